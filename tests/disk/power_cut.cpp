#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "tests/disk/file_calls.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;
using Kind = FileCall::Kind;

/// A file or folder, whatever its name.
struct Node {
  bool folder = false;
  std::string durable;  ///< content on the disk
  struct Change {
    bool truncates = false;
    std::uint64_t at = 0;
    std::string data;
    bool doomed = false;
  };
  std::vector<Change> pending;

  void apply(std::string& content, const Change& change) const {
    if (change.truncates) {
      content.resize(change.at);
    } else {
      if (content.size() < change.at) content.resize(change.at);  // a hole
      content.replace(change.at, change.data.size(), change.data);
    }
  }
};
using NodePtr = std::shared_ptr<Node>;
using Names = std::map<std::string, NodePtr>;  ///< by path

/// A change of names that its folder's sync makes durable.
struct NameChange {
  std::string removed, added;  ///< paths, empty for none
  NodePtr node;
  std::set<std::string> folders;  ///< whose sync is awaited
};

std::string parent_of(const std::string& path) {
  const auto slash = path.rfind('/');
  return slash == std::string::npos ? "." : path.substr(0, slash);
}

void perform(const NameChange& change, Names& names) {
  if (!change.removed.empty()) {
    const auto found = names.find(change.removed);
    if (found != names.end() && found->second == change.node) names.erase(found);
  }
  if (!change.added.empty()) names[change.added] = change.node;
}

class Disk {
 public:
  explicit Disk(const FileRecord& record) {
    for (const std::string& folder : record.folders)
      now_[folder] = std::make_shared<Node>(Node{.folder = true});
    for (const auto& [path, content] : record.files)
      now_[path] = std::make_shared<Node>(Node{.durable = content});
    durable_ = now_;
  }

  void run(const FileCall& call) {
    if (call.kind == Kind::Sync) return sync(call);
    if (call.failed) return;
    switch (call.kind) {
      case Kind::Create:
      case Kind::MakeFolder: {
        auto node = std::make_shared<Node>();
        node->folder = call.kind == Kind::MakeFolder;
        change({.added = call.path, .node = node, .folders = {parent_of(call.path)}});
        break;
      }
      case Kind::Write:
        now_.at(call.path)->pending.push_back({.at = call.at, .data = call.data});
        break;
      case Kind::Truncate:
        now_.at(call.path)->pending.push_back({.truncates = true, .at = call.at, .data = {}});
        break;
      case Kind::Rename:
        rename(call.path, call.to);
        break;
      case Kind::Unlink:
        change(
            {.removed = call.path, .node = now_.at(call.path), .folders = {parent_of(call.path)}});
        break;
      default:
        break;
    }
  }

  void write_below(const fs::path& folder, const std::function<bool()>& keep) const {
    Names names = durable_;
    for (const NameChange& pending : pending_)
      if (keep()) perform(pending, names);
    std::map<Node*, std::string> contents;
    for (const auto& [path, node] : names) {
      // A folder that is not on the disk takes what is in it along.
      bool reachable = true;
      for (std::string up = parent_of(path); up != "."; up = parent_of(up))
        reachable &= names.contains(up);
      if (!reachable) continue;
      if (node->folder) {
        fs::create_directories(folder / path);
        continue;
      }
      auto [content, fresh] = contents.try_emplace(node.get(), node->durable);
      if (fresh)
        for (const Node::Change& change : node->pending)
          if (keep()) node->apply(content->second, change);
      fs::create_directories((folder / path).parent_path());
      std::ofstream(folder / path, std::ios::binary) << content->second;
    }
  }

 private:
  void change(NameChange change) {
    perform(change, now_);
    pending_.push_back(std::move(change));
  }
  void rename(const std::string& from, const std::string& to) {
    const NodePtr node = now_.at(from);
    change(
        {.removed = from, .added = to, .node = node, .folders = {parent_of(from), parent_of(to)}});
    if (!node->folder) return;
    Names moved;
    for (const auto& [path, inner] : now_)
      if (path.starts_with(from + "/")) moved[path] = inner;
    for (const auto& [path, inner] : moved)
      change({.removed = path,
              .added = to + path.substr(from.size()),
              .node = inner,
              .folders = {parent_of(to)}});
  }
  void sync(const FileCall& call) {
    const auto found = now_.find(call.path);
    const bool folder = call.path == "." || (found != now_.end() && found->second->folder);
    if (folder) return sync_names(call);
    if (found == now_.end()) return;
    Node& node = *found->second;
    // What a failed sync did not write is clean for the system: no later sync writes it.
    for (Node::Change& change : node.pending) {
      if (call.failed) {
        change.doomed = true;
      } else if (!change.doomed) {
        node.apply(node.durable, change);
      }
    }
    if (!call.failed)
      std::erase_if(node.pending, [](const auto& change) { return !change.doomed; });
  }
  void sync_names(const FileCall& call) {
    if (call.failed) return;
    for (NameChange& pending : pending_) {
      if (!pending.folders.contains(call.path)) continue;
      // A rename is one change: the sync of either folder writes it.
      perform(pending, durable_);
      pending.folders.clear();
    }
    std::erase_if(pending_, [](const auto& change) { return change.folders.empty(); });
  }

  Names now_, durable_;
  std::vector<NameChange> pending_;
};

}  // namespace

void write_after_power_cut(const FileRecord& record, std::size_t count,
                           const std::function<bool()>& keep, const fs::path& folder) {
  Disk disk(record);
  for (std::size_t i = 0; i < count; ++i) disk.run(record.calls[i]);
  fs::create_directories(folder);
  disk.write_below(folder, keep);
}

}  // namespace remeshd::test
