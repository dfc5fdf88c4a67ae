#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

/// What the daemon lets peers, requests and computations take at most. Where remeshd has an option
/// for a limit, its default stands here. What an algorithm of the store or the service does with
/// bytes stands where it does it.
namespace remeshd::limits {

inline constexpr std::size_t kKibi = std::size_t{1} << 10U, kMebi = kKibi << 10U;

// Connections.

/// At a time (option `--max-connections`). One that says nothing costs some 50 KiB.
inline constexpr std::size_t kConnections = 1024;
/// Descriptors that connections leave to the store, the log, pipes of helpers, gRPC's polling.
inline constexpr std::size_t kOwnDescriptors = 256;
/// ms until a connection must have said what HTTP/2 begins with.
inline constexpr int kHandshakeMs = 20'000;
/// ms without a word after which a peer is pinged, and those in which it must answer or take data
/// that wait for it. The latter is TCP_USER_TIMEOUT too: shorter, and slow readers that live are
/// cut. Together they are the 90 s within which a frozen client's work ends.
inline constexpr int kKeepaliveMs = 60'000, kKeepaliveTimeoutMs = 30'000;
/// The client library pings once a second at most. Whoever pings more often than every so many ms
/// without being sent anything is disconnected at the ninth such ping.
inline constexpr int kPingIntervalMs = 500, kPingStrikes = 8;

// Calls and their messages.

/// Calls at a time on one connection; a client's further calls wait at the client.
inline constexpr int kStreamsPerConnection = 256;
/// Bytes of a request; what is larger is refused in words.
inline constexpr std::size_t kRequestBytes = 8 * kMebi;
/// Bytes that gRPC takes of a stream ahead of its reader. It keeps 32 bytes for each message among
/// them, and a message may have five.
inline constexpr int kReceiveWindow = 256 << 10U;
/// Bytes of a message beyond which gRPC refuses it itself.
inline constexpr int kReceivedMessage = 16 << 20U;
/// Bytes of all messages being received together. gRPC 1.51 receives a message whole before it
/// asks for its size, so that this alone bounds messages beyond `kReceivedMessage`. Where it is
/// reached, gRPC ends streams, and not always those of the connection that is to blame: it must
/// stay out of reach of clients that keep to the rules.
inline constexpr std::size_t kReceiveMemory = 256 * kMebi;
inline constexpr std::size_t kRequestIdBytes = 128;
/// Rows of a page of a list, and children that a revision's description names.
inline constexpr std::uint32_t kListRows = 1000;
inline constexpr int kChildren = 1000;
/// Bytes of a mesh in one message: below the 4 MiB that gRPC's clients take without being told, and
/// four of them are what a reader that pauses holds beside its mesh.
inline constexpr std::size_t kMeshPartBytes = kMebi - kKibi;
/// Bytes of the replies of a call that wait for its client, beyond which no more are made. So many
/// are taken from the memory budget: data of a mesh wait where they lie in the revision, but for
/// what TLS has encrypted of them already.
inline constexpr std::size_t kUntakenBytes = kMeshPartBytes;

// Of one EditStream: what waits in it.

inline constexpr std::size_t kStreamRequests = 4096;
inline constexpr std::size_t kStreamRequestBytes = 8 * kMebi;
inline constexpr std::size_t kStreamReplies = 256;
inline constexpr std::size_t kStreamReplyBytes = 4 * kMebi;
/// Replies with a mesh: each keeps that of a revision in memory.
inline constexpr std::size_t kStreamMeshes = 2;
/// Bytes that a stream takes from the memory budget for itself and for what waits in it up to
/// `kStreamSpare`; for more it takes more, so many at a time.
inline constexpr std::size_t kStreamMemory = 32 * kKibi, kStreamSpare = 8 * kKibi;

// Work.

/// Computations that may wait (`--queue`), s that one may wait (`--queue-wait`) and take
/// (`--compute-limit`).
inline constexpr std::size_t kQueue = 64;
inline constexpr double kQueueWait = 60, kComputeTime = 600;
/// Threads that answer from the catalogue alone, and that read, prepare and write the catalogue.
inline constexpr int kMetadataThreads = 2, kPreparationThreads = 4;
/// Work that may wait in either of these lanes.
inline constexpr std::size_t kLaneQueue = 1024;
/// Of computations: a refusal, health or a progress event does not wait for the end of a worker's
/// turn on the processor.
inline constexpr int kComputationNiceness = 5;
/// A tenant that asked within this time is active: while several are, none has all workers.
inline constexpr std::chrono::seconds kActiveTenant(60);
/// Requests that are prepared though no computation may wait, at once and a second: what they ask
/// for may be there already. A preparation costs some ms: so many leave the workers their
/// processors.
inline constexpr double kSparePlaces = 4, kSparePlacesPerSecond = 5;
/// s that a refused client is told to wait, and the share of it that chance adds or takes.
inline constexpr double kLeastDelay = 0.1, kMostDelay = 60, kDelayJitter = 0.2;

// Memory.

/// Bytes that computations, loads, requests and revisions held may take together (`--memory`), and
/// revisions held of it (`--cache`).
inline constexpr std::uint64_t kMemory = 2048 * kMebi, kHeld = 1024 * kMebi;
/// Bytes a node that a computation takes at its peak, beside its base (tests/bench/results.md:
/// 1,411), and likewise the reading of a revision.
inline constexpr std::uint64_t kBytesPerNode = 1500;
/// s that the reading of a revision waits for memory, and that one is told to wait who finds none.
inline constexpr double kLoadWait = 60, kMemoryDelay = 1;
/// Of the budget: what the process stays below it, for what no estimate tells of; twice that is
/// freed once it does not, so that not every lease has to.
inline constexpr std::uint64_t kMarginShare = 10;
/// Of the budget: what the revisions held keep all the same, or the next request finds none.
inline constexpr std::uint64_t kKeptShare = 4;
/// The process is looked at so often, and what it freed given back to the system where it grew by
/// so many bytes since it last was.
inline constexpr std::chrono::seconds kReturnInterval(10);
inline constexpr std::uint64_t kReturnGrowth = 16 * kMebi;

// The shared tier.

/// s that a tier that fails is left alone.
inline constexpr std::chrono::seconds kTierRest(10);
/// s in which it has to tell whether it has a mesh that is just being computed, and another one.
inline constexpr double kTierLookUp = 0.05, kTierAnswer = 2;
/// For how long a daemon that has seen a recipe in it takes it for being there.
inline constexpr std::chrono::hours kTierRefresh(7 * 24);
/// Bytes of an object; what is larger is none of the daemon's.
inline constexpr std::size_t kTierObjectBytes = 1024 * kMebi;

// The process.

/// s beyond the grace time (`--grace`) until a daemon that does not come to rest is ended by force:
/// computations hear of their end within a fraction of a second.
inline constexpr double kUntilRest = 8;
/// Scrapes of the metrics at a time, and ms that one may say nothing: there is one scraper, or two.
inline constexpr int kScrapes = 2, kScrapeTimeoutMs = 5'000;

// Files of the operator's. Larger ones are a mistake.

inline constexpr std::size_t kSecretFileBytes = kMebi, kConfigFileBytes = kMebi;

}  // namespace remeshd::limits
