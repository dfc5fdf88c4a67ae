#include "client/cli/report/page.h"

#include <stdexcept>

#include "client/cli/reply.h"
#include "client/cli/report/correspondence.h"
#include "client/cli/report/figures.h"
#include "client/cli/report/page_arrays.h"
#include "client/cli/report/page_parts.h"
#include "client/cli/report/tet_figures.h"

namespace remeshd::cli {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else
      out += c;
  }
  return out;
}

/// JSON that cannot end the script element that it stands in.
std::string for_script(const nlohmann::ordered_json& json) {
  std::string out;
  for (const char c : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) {
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  }
  return out;
}

/// Adds the arrays of one mesh, each in an element of its own, and their list to its figures.
void add_arrays(const std::string& side, const PageMesh& mesh, nlohmann::ordered_json& figures,
                std::string& elements) {
  auto& list = figures["arrays"] = nlohmann::ordered_json::array();
  for (const PageArray& array : page_arrays(mesh)) {
    const std::string element = "data-" + side + "-" + array.name;
    list.push_back({{"name", array.name},
                    {"type", array.type},
                    {"components", array.components},
                    {"count", array.count},
                    {"element", element}});
    elements += "<script type=\"application/octet-stream\" id=\"" + element + "\">" +
                packed(array.bytes) + "</script>\n";
  }
}

std::string data_of(const ReportContent& content) {
  const Correspondence correspondence = correspond(content);
  const MeshFigures modified = figures_of_tets(content.modified.mesh);
  const MeshFigures base = content.base ? figures_of_tets(content.base->mesh) : MeshFigures{};
  auto figures = report_figures(content, correspondence, content.base ? &base : nullptr, modified);
  figures["version"] = REMESHD_VERSION;
  const auto centre = centre_of(content);
  const bool surfaces_only = has_surfaces_only(content);
  std::string elements;
  if (content.base)
    add_arrays("base",
               {.mesh = content.base->mesh,
                .figures = base,
                .states = correspondence.base,
                .centre = centre,
                .surfaces_only = surfaces_only},
               figures["base"]["mesh"], elements);
  add_arrays("modified",
             {.mesh = content.modified.mesh,
              .figures = modified,
              .states = correspondence.modified,
              .centre = centre,
              .surfaces_only = surfaces_only},
             figures["modified"]["mesh"], elements);
  return "<script type=\"application/json\" id=\"figures\">" + for_script(figures) + "</script>\n" +
         elements;
}

std::string title_of(const ReportContent& content) {
  const std::string name = short_name(content.modified.about.revision());
  return content.base ? short_name(content.base->about.revision()) + " \u2192 " + name : name;
}

}  // namespace

std::string report_page(const ReportContent& content) {
  std::string page;
  std::string_view rest = kPageTemplate;
  while (true) {
    const auto begin = rest.find("{{"), end = rest.find("}}");
    page += rest.substr(0, begin);
    if (begin == std::string_view::npos) return page;
    const std::string_view name = rest.substr(begin + 2, end - begin - 2);
    if (name == "title")
      page += escaped(title_of(content));
    else if (name == "style")
      page += kPageStyle;
    else if (name == "script")
      page += kPageScript;
    else if (name == "data")
      page += data_of(content);
    else
      throw std::logic_error("the page's template has no part " + std::string(name));
    rest.remove_prefix(end + 2);
  }
}

}  // namespace remeshd::cli
