#include "server/tier/sharing.h"

#include <utility>

#include "server/tier/breaker.h"
#include "server/tier/folder_objects.h"
#include "server/tier/http_objects.h"

namespace remeshd {

bool is_http(const std::string& place) {
  return place.starts_with("http://") || place.starts_with("https://");
}

std::shared_ptr<ObjectStore> open_objects(const std::string& place, const std::string& s3_region,
                                          const TierSecrets& secrets,
                                          const std::function<void(const std::string&)>& tell) {
  std::unique_ptr<ObjectStore> objects;
  if (is_http(place)) {
    HttpAccess access{.url = place,
                      .region = s3_region,
                      .access_key = secrets.access_key,
                      .secret_key = secrets.secret_key};
    while (access.url.ends_with('/')) access.url.pop_back();
    objects = std::make_unique<HttpObjects>(std::move(access));
  } else {
    auto folder = std::make_unique<FolderObjects>(place);
    if (folder->begun() && tell)
      tell("is new: " + place + " was empty; was its file system mounted?");
    objects = std::move(folder);
  }
  return std::make_shared<Breaker>(std::move(objects), [tell](const std::string& why) {
    if (tell) tell(why.empty() ? "answers again" : why + "; it is left alone for a while");
  });
}

}  // namespace remeshd
