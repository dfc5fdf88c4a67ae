#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string_view>

#include "tests/client/cli/cli_fixture.h"
#include "tests/client/cli/report/page_reader.h"

namespace remeshd::cli {
namespace {

using remesh::v1::Report;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class ReportPage : public Cli {
 protected:
  ReportPage() {
    service_.stored_report.set_way(Report::WAY_LOCAL);
    service_.stored_report.set_order(1);
    service_.stored_report.mutable_seconds()->set_total(0.5);
    service_.mesh.original_tet.assign(service_.mesh.tets.size(), -1);
    service_.mesh.original_tet[3] = 5;
  }

  /// The page of these revisions.
  std::string page_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "report");
    arguments.insert(arguments.end(), {"-o", file("report.html")});
    EXPECT_EQ(run(arguments), kFine) << err_.str();
    std::ifstream in(folder_ / "report.html");
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

/// The page but for what stands in its script elements.
std::string without_scripts(std::string page) {
  constexpr std::string_view kEnd = "</script>";
  for (auto at = page.find("<script"); at != std::string::npos; at = page.find("<script", at))
    page.erase(at, page.find(kEnd, at) + kEnd.size() - at);
  return page;
}

TEST_F(ReportPage, LoadsNothing) {
  service_.stored_parent = "id-of-before";
  const std::string page = page_of({"before", "after"});
  EXPECT_THAT(page, Not(HasSubstr("<script src")));
  const std::string html = without_scripts(page);
  EXPECT_THAT(html, Not(HasSubstr(" src=")));
  EXPECT_THAT(html, Not(HasSubstr("<link")));
  EXPECT_THAT(html, Not(HasSubstr("@import")));
  EXPECT_THAT(html, Not(HasSubstr("url(")));
  EXPECT_THAT(html, Not(HasSubstr("http:")));
  EXPECT_THAT(html, Not(HasSubstr("https:")));
  EXPECT_THAT(page, HasSubstr("default-src 'none'")) << "the browser is told to load nothing";
  for (const char* left_out : {"{{title}}", "{{style}}", "{{data}}", "{{script}}"})
    EXPECT_THAT(page, Not(HasSubstr(left_out)));
}

TEST_F(ReportPage, HasTheArraysOfBothMeshes) {
  service_.stored_parent = "id-of-before";
  const std::string page = page_of({"before", "after"});
  const auto figures = figures_in(page);
  EXPECT_EQ(figures["descent"], "parent");
  for (const std::string side : {"base", "modified"}) {
    const auto& mesh = figures[side]["mesh"];
    EXPECT_EQ(mesh["tets"], service_.mesh.tets.size());
    for (const auto& array : mesh["arrays"]) {
      const std::string bytes = unpacked(element_text(page, array["element"]));
      const std::size_t width = array["type"] == "u8" ? 1 : 4;
      EXPECT_EQ(bytes.size(),
                array["count"].get<std::size_t>() * array["components"].get<std::size_t>() * width)
          << array;
    }
    const auto tets = numbers<std::int32_t>(unpacked(element_text(page, "data-" + side + "-tets")));
    ASSERT_EQ(tets.size(), 4 * service_.mesh.tets.size());
    EXPECT_EQ(tets[6], service_.mesh.tets[1][2]);
  }
  const auto states =
      numbers<std::uint8_t>(unpacked(element_text(page, "data-modified-tet_state")));
  EXPECT_EQ(states[3], 1) << "kept";
  EXPECT_EQ(figures["counts"]["tets"]["kept"], 1);
}

TEST_F(ReportPage, TellsWhatTheRevisionsAre) {
  service_.stored_parent = "id-of-before";
  auto& warning = *service_.stored_report.add_warnings();
  warning.set_code(remesh::v1::Warning::QUALITY_LOW);
  warning.set_message("a tet </script><b> is flat & thin");
  const std::string page = page_of({"before", "after"});
  EXPECT_THAT(page, HasSubstr("<title>before@7 \u2192 after@7</title>"));
  EXPECT_THAT(page, HasSubstr("<html lang=\"en\""));
  const auto figures = figures_in(page);
  EXPECT_THAT(figures["changes"], IsEmpty());
  EXPECT_EQ(figures["modified"]["way"], "local");
  EXPECT_EQ(figures["modified"]["features"], nlohmann::json({"hub"}));
  EXPECT_EQ(figures["modified"]["report"]["warnings"][0]["message"],
            "a tet </script><b> is flat & thin");
}

TEST_F(ReportPage, OfOneRevisionComparesItWithItsParent) {
  service_.stored_parent = "before";
  const auto figures = figures_in(page_of({"after"}));
  EXPECT_EQ(figures["base"]["name"], "before@7");
  EXPECT_EQ(figures["modified"]["name"], "after@7");
}

TEST_F(ReportPage, OfAFirstMeshIsAboutItAlone) {
  const std::string page = page_of({"tool1-a"});
  const auto figures = figures_in(page);
  EXPECT_TRUE(figures["base"].is_null());
  EXPECT_TRUE(figures["changes"].is_null());
  EXPECT_THAT(page, HasSubstr("<title>tool1-a@7</title>"));
}

TEST_F(ReportPage, OfSurfacesAloneHasTheWorstTetsStill) {
  const std::string page = page_of({"tool1-a", "--surfaces"});
  const auto figures = figures_in(page);
  EXPECT_EQ(figures["surfaces_only"], true);
  EXPECT_THAT(page, Not(HasSubstr("data-modified-tets")));
  ASSERT_EQ(figures["modified"]["mesh"]["worst"].size(), 10U);
  EXPECT_EQ(figures["modified"]["mesh"]["worst"][0]["corners"].size(), 4U);
}

TEST_F(ReportPage, OfRevisionsOfDifferentChainsSaysSo) {
  service_.stored_parent = "id-of-another";
  EXPECT_EQ(figures_in(page_of({"before", "after"}))["descent"], "none");
}

TEST_F(ReportPage, IsAboutRevisionsAndNotAboutFiles) {
  EXPECT_EQ(run({"report", kCases + "/tool1-a.json", "-o", file("r.html")}), kUsage);
  EXPECT_THAT(err_.str(), HasSubstr("a report is about revisions"));
  EXPECT_EQ(run({"report", "a", "b", "c", "-o", file("r.html")}), kUsage);
  EXPECT_EQ(run({"report", "a", "-o", file("no/folder/r.html")}), kFileFailed);
  EXPECT_THAT(err_.str(), HasSubstr("there is no folder"));
  EXPECT_EQ(run({"report", "a"}), kUsage) << "without -o";
}

TEST_F(ReportPage, OfWhatTheDaemonLacksIsAnError) {
  service_.failure =
      client::make_error(remesh::v1::Error::CODE_NOT_FOUND, remesh::v1::Error::REASON_UNSPECIFIED);
  EXPECT_EQ(run({"report", "nothing", "-o", file("r.html")}), kInvalid);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "r.html"));
}

}  // namespace
}  // namespace remeshd::cli
