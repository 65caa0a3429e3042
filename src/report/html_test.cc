// SPDX-License-Identifier: Apache-2.0
#include "report/html.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/evaluation_table.h"

namespace dorsum {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* kHostile = "<script>alert('x')</script>\"onload=\"y & z";

TEST(Html, HostileTextIsEscapedWhereverItStands) {
  HtmlPage page(kHostile, kHostile);
  page.Section(kHostile, kHostile);
  page.Paragraph(kHostile);
  page.Facts({{kHostile, kHostile, kHostile}});
  page.Warnings({kHostile});
  page.Verdicts({{kHostile, Grade::kBad, kHostile, {{kHostile, 1.0, kHostile}}}});
  page.Figures({{cv::Mat(4, 4, CV_8UC3, cv::Scalar(1, 2, 3)), ImageKind::kDrawing, kHostile, kHostile}});
  page.Table({{kHostile}, {{kHostile}}, 1, kHostile});
  const std::string html = page.Finish(kHostile);
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, Not(HasSubstr("\"onload")));
  EXPECT_THAT(html, HasSubstr("&lt;script&gt;"));
  EXPECT_THAT(html, HasSubstr("y &amp; z"));
}

TEST(Html, ControlCharactersAreDropped) { EXPECT_EQ(EscapeHtml(std::string("a\0b\x1b\nc", 6)), "ab c"); }

TEST(Html, AGradeIsAlsoAWord) {
  HtmlPage page("t", "");
  page.Verdicts({{"camera", Grade::kDoubtful, "so so", {}}});
  EXPECT_THAT(page.Finish(""), HasSubstr("&#9888; doubtful"));
}

TEST(Html, ThePolicyAllowsItsOwnStyleAndPicturesAndNothingElse) {
  EXPECT_THAT(HtmlPage("t", "").Finish(""),
              HasSubstr(R"(content="default-src 'none'; img-src data:; style-src 'unsafe-inline'")"));
}

TEST(Html, PicturesAreEmbedded) {
  const cv::Mat picture(8, 8, CV_8UC3, cv::Scalar(1, 2, 3));
  EXPECT_THAT(ImageUri(picture, ImageKind::kPhoto), StartsWith("data:image/jpeg;base64,/9j/"));
  EXPECT_THAT(ImageUri(picture, ImageKind::kDrawing), StartsWith("data:image/png;base64,iVBOR"));
  EXPECT_EQ(ImageUri({}, ImageKind::kPhoto), "");
}

TEST(Html, EvaluationTableShowsTheDocumentsFigures) {
  HtmlPage page("t", "");
  AddEvaluation(page, {{"Laser 0", 1.2816, 0.1671, 2000}, {"Merged", 0.9114, 0.1155, 5900}});
  AddEvaluation(page, {{"odd", std::numeric_limits<double>::quiet_NaN(), 0.0, 0}});
  const std::string html = page.Finish("");
  for (const char* text : {"RMSE (mm)", "NRMSE", "1.2816", "0.1671", "2000", "Merged", "width:100.0%"}) {
    EXPECT_THAT(html, HasSubstr(text));
  }
  EXPECT_THAT(html, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace dorsum
