// Requests as they come from the wire: the first byte chooses the rpc, the rest are the message's
// bytes. Each goes the way of its handler up to where a mesh would be made or something be changed.
#include <google/protobuf/util/message_differencer.h>

#include "proto/document.h"
#include "proto/json_writer.h"
#include "remesh/v1/cache.pb.h"
#include "remesh/v1/remesh.pb.h"
#include "remesh/v1/rpc_status.pb.h"
#include "server/service/cache_list.h"
#include "server/service/call.h"
#include "server/service/decode.h"
#include "server/service/encode.h"
#include "server/service/encode_cache.h"
#include "server/service/lists.h"
#include "server/service/mesh_messages.h"
#include "server/service/page_token.h"
#include "server/service/request_id.h"
#include "server/service/request_limits.h"
#include "server/service/status.h"
#include "server/service/stream_request.h"
#include "server/service/trace_parent.h"
#include "server/session/mesh_options.h"
#include "tests/fuzz/documents.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/quiet_session.h"
#include "tests/fuzz/targets.h"

namespace remeshd::fuzz {
namespace {

namespace v1 = remesh::v1;

const RequestLimits kLimits;

template <typename Request>
Request parsed(std::string_view bytes) {
  Request request;
  from_bytes(bytes, kLimits.message_bytes, request);
  return request;
}

/// An answer is sent as bytes that a client can read.
void expect_sendable(const google::protobuf::Message& answer) {
  const std::string bytes = answer.SerializeAsString();
  const std::unique_ptr<google::protobuf::Message> again(answer.New());
  expect(again->ParseFromString(bytes), "an answer that no client can read");
}

void check_command(const CreateCommand& command) {
  quiet_session().validate(command.source, command.options, {});
}

void check_command(const EditCommand& command) {
  edit_options(command.options, {});
  quiet_session().validate_edit(command.base, command.edit, command.options, {});
  // Only an edit that is right is kept.
  expect(write_document(parse_edit(command.document)) == command.document,
         "an edit is kept as another document");
}

template <typename Request>
void make(std::string_view bytes) {
  const auto request = parsed<Request>(bytes);
  expect(echoed_request_id(request.request_id()).size() <= 128, "a long id is echoed");
  check_request_id(request.request_id());
  check_command(decode(request, kLimits.document));
}

void edit_stream(std::string_view bytes) {
  const StreamRequestHead head = read_head(bytes);
  const auto request = parsed<v1::EditStreamRequest>(bytes);
  const std::string& id = request.has_edit()     ? request.edit().request_id()
                          : request.has_create() ? request.create().request_id()
                                                 : request.cancel().request_id();
  expect(head.request_id == id, "the head of a message has another id than the message");
  expect(head.is_cancel == request.has_cancel(), "the head takes a request for another");
  check_selection(request.mesh());
  if (request.has_edit()) check_command(decode(request.edit(), kLimits.document));
  if (request.has_create()) check_command(decode(request.create(), kLimits.document));
}

void get_mesh(std::string_view bytes) {
  const auto request = parsed<v1::GetMeshRequest>(bytes);
  check_selection(request.selection());
  const HeldRevisionPtr revision = quiet_session().get(request.revision(), {});
  const HeldRevisionPtr parent =
      request.selection().delta() ? quiet_session().parent_of(*revision, {}) : nullptr;
  MeshMessages messages(revision, parent, request.selection());
  if (request.has_resume_from()) messages.resume_from(request.resume_from());
  v1::MeshMessage message;
  PartData data;
  for (int count = 0; messages.next(message, data); ++count) {
    for (const std::string_view piece : data.pieces)
      message.mutable_part()->mutable_data()->append(piece);
    expect_sendable(message);
    expect(count < 1000, "a mesh without an end");
  }
}

void get_revision(std::string_view bytes) {
  const auto request = parsed<v1::GetRevisionRequest>(bytes);
  Session& session = quiet_session();
  const Reference reference = session.resolve(request.revision());
  expect_sendable(encode(session.describe(reference, {}), request.documents()));
}

void name_a_revision(std::string_view bytes) {
  quiet_session().resolve(parsed<v1::SetHeadRequest>(bytes).revision());
}

void get_recipe(std::string_view bytes) {
  const auto request = parsed<v1::GetRecipeRequest>(bytes);
  expect_sendable(encode(quiet_session().recipe(request.revision())));
}

void list_revisions(std::string_view bytes) {
  expect_sendable(
      remeshd::list_revisions(quiet_session(), parsed<v1::ListRevisionsRequest>(bytes)));
}

void list_designs(std::string_view bytes) {
  expect_sendable(remeshd::list_designs(quiet_session(), parsed<v1::ListDesignsRequest>(bytes)));
}

void list_cache_entries(std::string_view bytes) {
  expect_sendable(
      remeshd::list_cache_entries(quiet_session(), parsed<v1::ListCacheEntriesRequest>(bytes)));
}

void compare(std::string_view bytes) {
  const auto request = parsed<v1::CompareRequest>(bytes);
  expect_sendable(encode(
      quiet_session().compare(decode(request.original(), "original", kLimits.document),
                              decode(request.modified(), "modified", kLimits.document), {})));
}

void validate_model(std::string_view bytes) {
  const auto request = parsed<v1::ValidateModelRequest>(bytes);
  const ModelSource source = decode(request, kLimits.document);
  expect_sendable(encode(quiet_session().validate(source, decode(request.options()), {})));
}

void validate_edit(std::string_view bytes) {
  const auto request = parsed<v1::ValidateEditRequest>(bytes);
  const EditToValidate what = decode(request, kLimits.document);
  expect_sendable(
      encode(quiet_session().validate_edit(what.base, what.edit, decode(request.options()), {})));
}

void model_message(std::string_view bytes) { check_model(parsed<v1::FeatureModel>(bytes)); }
void edit_message(std::string_view bytes) { check_edit(parsed<v1::ModelEdit>(bytes)); }

void page_token(std::string_view bytes) {
  const ListIdentity list("revisions", v1::RevisionFilter(), 0, false);
  // The digest that a token begins with is not to be guessed.
  const std::string start = list.token(0, "", 0, "").substr(0, 17);
  const std::string text = start + std::string(bytes);
  const ListIdentity::Row row = list.read(text);
  const ListIdentity::Row again = list.read(list.token(row.value, row.id, row.number, row.name));
  expect(again.value == row.value && again.id == row.id && again.number == row.number &&
             again.name == row.name,
         "a token is read as another row than it was written for");
}

void trace_parent(std::string_view bytes) {
  if (is_trace_parent(bytes)) expect(bytes.size() <= 256, "a long traceparent");
}

struct Rpc {
  void (*handle)(std::string_view bytes);
};
constexpr Rpc kRpcs[] = {{make<v1::CreateRevisionRequest>},
                         {make<v1::EditRevisionRequest>},
                         {edit_stream},
                         {get_mesh},
                         {get_revision},
                         {get_recipe},
                         {list_revisions},
                         {list_designs},
                         {list_cache_entries},
                         {name_a_revision},
                         {compare},
                         {validate_model},
                         {validate_edit},
                         {model_message},
                         {edit_message},
                         {page_token},
                         {trace_parent}};

/// What the client gets of an error has what it says, and can be read.
void expect_told(const Error& error) {
  const grpc::Status status = to_status(error);
  v1::RpcStatus details;
  expect(details.ParseFromString(status.error_details()), "details that no client can read");
  expect(!status.ok(), "an error that is none for the client");
  const v1::Error message = to_message(error);
  expect(message.reason() != v1::Error::REASON_UNSPECIFIED,
         "a reason that is none of the protocol: " + error.info().reason);
}

template <typename Message>
void add(Seeds& seeds, int rpc, const Message& message) {
  seeds.push_back(static_cast<char>(rpc) + message.SerializeAsString());
}

}  // namespace
}  // namespace remeshd::fuzz

int fuzz_requests(const std::uint8_t* data, std::size_t size) {
  using namespace remeshd;
  fuzz::Input input(data, size);
  const auto& rpc = fuzz::kRpcs[input.byte() % std::size(fuzz::kRpcs)];
  try {
    rpc.handle(input.rest());
  } catch (const Error& error) {
    fuzz::expect_in_words(error);
    fuzz::expect_told(error);
  } catch (const DocumentError& error) {
    fuzz::expect(false, std::string("a document's error that no client gets: ") + error.what());
  }
  return 0;
}

remeshd::fuzz::Seeds remeshd::fuzz::request_seeds() {
  Seeds seeds;
  const v1::FeatureModel model = parse_model(kModelOfEveryType);
  const v1::ModelEdit edit =
      parse_edit(R"({"edits": [{"setParameter": {"name": "r", "value": "h/3"}}]})");
  const std::string id = quiet_session().resolve("plate").id;

  v1::CreateRevisionRequest create;
  *create.mutable_model() = model;
  create.mutable_options()->set_nodes(100);
  create.mutable_options()->add_fail_on(v1::Warning::FALLBACK);
  create.mutable_head()->set_advance(true);
  create.set_design("plate");
  create.set_request_id("request");
  add(seeds, 0, create);
  create.mutable_options()->set_size(2.5);
  create.set_document(kModelOfEveryType);
  add(seeds, 0, create);
  v1::EditRevisionRequest change;
  change.set_base("plate");
  *change.mutable_edit() = edit;
  add(seeds, 1, change);
  change.set_document(write_document(edit));
  add(seeds, 1, change);

  v1::EditStreamRequest streamed;
  *streamed.mutable_edit() = change;
  streamed.mutable_mesh()->set_delta(true);
  streamed.mutable_mesh()->add_arrays(v1::MESH_ARRAY_NODES);
  add(seeds, 2, streamed);
  *streamed.mutable_create() = create;
  add(seeds, 2, streamed);
  streamed.mutable_cancel()->set_request_id("request");
  add(seeds, 2, streamed);

  v1::GetMeshRequest mesh;
  mesh.set_revision("plate");
  add(seeds, 3, mesh);
  mesh.mutable_selection()->set_delta(true);
  mesh.mutable_resume_from()->set_array(v1::MESH_ARRAY_TETS);
  mesh.mutable_resume_from()->set_offset(16);
  add(seeds, 3, mesh);
  v1::GetRevisionRequest revision;
  for (const std::string& name : {id, id.substr(0, 9), std::string("plate@1")}) {
    revision.set_revision(name);
    revision.set_documents(true);
    add(seeds, 4, revision);
    add(seeds, 5, revision);
    add(seeds, 9, revision);
  }
  v1::ListRevisionsRequest list;
  list.mutable_filter()->set_design("plate");
  list.mutable_filter()->mutable_created_from()->set_seconds(1);
  list.mutable_filter()->set_algorithm_version(13);
  list.set_page_size(1);
  list.set_order(v1::REVISION_ORDER_NODES);
  list.set_page_token(remeshd::list_revisions(quiet_session(), list).next_page_token());
  add(seeds, 6, list);
  v1::ListDesignsRequest designs;
  designs.mutable_filter()->set_prefix("pl");
  designs.mutable_filter()->mutable_changed_before()->set_seconds(1LL << 40);
  designs.set_order(v1::DESIGN_ORDER_CHANGED);
  add(seeds, 7, designs);
  v1::ListCacheEntriesRequest entries;
  entries.mutable_filter()->set_design("plate");
  entries.set_page_size(1);
  add(seeds, 8, entries);

  v1::CompareRequest comparison;
  comparison.mutable_original()->set_revision("plate");
  *comparison.mutable_modified()->mutable_edit() = edit;
  add(seeds, 10, comparison);
  *comparison.mutable_original()->mutable_model() = model;
  comparison.mutable_modified()->set_document(kModelOfEveryType);
  add(seeds, 10, comparison);
  v1::ValidateModelRequest validate;
  *validate.mutable_model() = model;
  validate.mutable_options()->set_size(1);
  add(seeds, 11, validate);
  v1::ValidateEditRequest edited;
  edited.set_base_document(kModelOfEveryType);
  *edited.mutable_edit() = edit;
  add(seeds, 12, edited);
  add(seeds, 13, model);
  for (const std::string& text : edit_seeds()) add(seeds, 14, parse_edit(text));
  seeds.push_back(static_cast<char>(15) + ("12." + id + ".3.plate"));
  seeds.push_back(static_cast<char>(16) +
                  std::string("00-0af7651916cd43dd8448eb211c80319c-b7ad6b7169203331-01"));
  return seeds;
}
