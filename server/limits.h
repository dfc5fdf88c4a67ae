#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

/// What the daemon lets peers, requests and computations take at most. Where remeshd has an option
/// for a limit, its default stands here. Sizes that only one algorithm of the store or the service
/// uses stand beside that algorithm.
namespace remeshd::limits {

inline constexpr std::size_t kKibi = std::size_t{1} << 10U, kMebi = kKibi << 10U;

// Connections.

/// At a time (option `--max-connections`). One that says nothing costs some 50 KiB.
inline constexpr std::size_t kConnections = 1024;
/// Descriptors that connections leave to the store, the log, pipes of helpers, gRPC's polling.
inline constexpr std::size_t kOwnDescriptors = 256;
/// ms within which a new connection must have completed its handshakes, of TLS and HTTP/2.
inline constexpr int kHandshakeMs = 20'000;
/// ms of silence after which a peer is pinged, and ms within which it must answer the ping and
/// acknowledge data sent to it (the latter as TCP_USER_TIMEOUT; a shorter one would disconnect live
/// clients that read slowly). Together they are the 90 s within which the work for a frozen client
/// ends.
inline constexpr int kKeepaliveMs = 60'000, kKeepaliveTimeoutMs = 30'000;
/// The client library pings once a second at most. A peer that pings more often than once in so
/// many ms while nothing is sent to it is disconnected at its ninth such ping.
inline constexpr int kPingIntervalMs = 500, kPingStrikes = 8;

// Calls and their messages.

/// Calls at a time on one connection; a client's further calls wait at the client.
inline constexpr int kStreamsPerConnection = 256;
/// Bytes of a request; what is larger is refused in words.
inline constexpr std::size_t kRequestBytes = 8 * kMebi;
/// Bytes that gRPC receives of a stream ahead of its reader (flow-control window). For each message
/// among them it keeps 32 bytes of its own, and a message may be as short as five bytes.
inline constexpr int kReceiveWindow = 256 << 10U;
/// Bytes of a message beyond which gRPC refuses it itself.
inline constexpr int kReceivedMessage = 16 << 20U;
/// Bytes of all messages being received together. gRPC 1.51 receives a message whole before it
/// checks its size, so that this alone bounds messages beyond `kReceivedMessage`. Where it is
/// reached, gRPC ends streams, and not always those of the connection that is to blame: it must
/// stay out of reach of clients that keep to the rules.
inline constexpr std::size_t kReceiveMemory = 256 * kMebi;
inline constexpr std::size_t kRequestIdBytes = 128;
/// Rows of a page of a list, and children that a revision's description names.
inline constexpr std::uint32_t kListRows = 1000;
inline constexpr int kChildren = 1000;
/// Bytes of a mesh in one message: below the 4 MiB that gRPC's clients accept by default. A reader
/// that pauses holds up to four such messages beside its mesh.
inline constexpr std::size_t kMeshPartBytes = kMebi - kKibi;
/// Bytes of a call's replies that may wait for its client; the server makes no more until the
/// client has taken some. As many bytes are leased from the memory budget: mesh data are sent from
/// the memory of the revision, and only TLS copies them, as it encrypts.
inline constexpr std::size_t kUntakenBytes = kMeshPartBytes;

// Of one EditStream: what waits in it.

inline constexpr std::size_t kStreamRequests = 4096;
inline constexpr std::size_t kStreamRequestBytes = 8 * kMebi;
inline constexpr std::size_t kStreamReplies = 256;
inline constexpr std::size_t kStreamReplyBytes = 4 * kMebi;
/// Replies with a mesh: each keeps that of a revision in memory.
inline constexpr std::size_t kStreamMeshes = 2;
/// Bytes that a stream leases from the memory budget for itself and up to `kStreamSpare` bytes that
/// wait in it; for more it leases further multiples of `kStreamMemory`.
inline constexpr std::size_t kStreamMemory = 32 * kKibi, kStreamSpare = 8 * kKibi;

// Work.

/// Computations that may wait (`--queue`), s that one may wait (`--queue-wait`) and take
/// (`--compute-limit`).
inline constexpr std::size_t kQueue = 64;
inline constexpr double kQueueWait = 60, kComputeTime = 600;
/// Threads of the lane of metadata, which answers from the catalogue alone, and of the lane of
/// preparations, which reads revisions and writes the catalogue.
inline constexpr int kMetadataThreads = 2, kPreparationThreads = 4;
/// Pieces of work that may wait in each of these two lanes.
inline constexpr std::size_t kLaneQueue = 1024;
/// Niceness of the threads that compute, so that a refusal, a health check or a progress event need
/// not wait for the end of their time slice.
inline constexpr int kComputationNiceness = 5;
/// A tenant that asked within this time is active: while several are, none has all workers.
inline constexpr std::chrono::seconds kActiveTenant(60);
/// Requests that are prepared although the queue of computations is full, in a burst and per second
/// (a token bucket): what they ask for may exist already. A preparation costs some ms, so that this
/// rate leaves the workers their processors.
inline constexpr double kSparePlaces = 4, kSparePlacesPerSecond = 5;
/// Least and most s that a refused client is told to wait, and the share of it by which that is
/// changed at random, up or down.
inline constexpr double kLeastDelay = 0.1, kMostDelay = 60, kDelayJitter = 0.2;

// Memory.

/// Bytes that computations, loads, requests and revisions held may take together (`--memory`), and
/// revisions held of it (`--cache`).
inline constexpr std::uint64_t kMemory = 2048 * kMebi, kHeld = 1024 * kMebi;
/// Bytes a node that a computation takes at its peak, beside its base (tests/bench/results.md:
/// 1,411), and likewise the reading of a revision.
inline constexpr std::uint64_t kBytesPerNode = 1500;
/// s that the reading of a revision waits for memory, and s after which a client is told to come
/// back where there is none.
inline constexpr double kLoadWait = 60, kMemoryDelay = 1;
/// The margin is 1/kMarginShare of the budget. The process is to stay below the budget by it,
/// because of memory that no estimate covers. When it does not, revisions held are evicted until it
/// is below by twice the margin, so that not every lease has to evict some.
inline constexpr std::uint64_t kMarginShare = 10;
/// Eviction for that margin leaves the revisions held at least 1/kKeptShare of the budget;
/// otherwise the next request would find none in memory.
inline constexpr std::uint64_t kKeptShare = 4;
/// How often the memory of the process is measured, and bytes by which it must have grown since
/// freed memory was last returned to the system for that to be done again.
inline constexpr std::chrono::seconds kReturnInterval(10);
inline constexpr std::uint64_t kReturnGrowth = 16 * kMebi;

// The shared tier.

/// s that a tier that fails is left alone.
inline constexpr std::chrono::seconds kTierRest(10);
/// s within which the tier has to tell whether it has a mesh that is wanted now (else this daemon
/// loads or computes it), and whether it has one that is to be written to it.
inline constexpr double kTierLookUp = 0.05, kTierAnswer = 2;
/// For how long a daemon relies on the tier still having a recipe that it has seen there.
inline constexpr std::chrono::hours kTierRefresh(7 * 24);
/// Bytes of an object; what is larger is none of the daemon's.
inline constexpr std::size_t kTierObjectBytes = 1024 * kMebi;

// The process.

/// s beyond the grace time (`--grace`) until a daemon that does not come to rest is ended by force:
/// computations hear of their end within a fraction of a second.
inline constexpr double kUntilRest = 8;
/// Scrapes of the metrics at a time, and ms that one may be silent: there are one or two scrapers.
inline constexpr int kScrapes = 2, kScrapeTimeoutMs = 5'000;

// Bytes of the operator's files. A larger one is a mistake.

inline constexpr std::size_t kSecretFileBytes = kMebi, kConfigFileBytes = kMebi;

}  // namespace remeshd::limits
