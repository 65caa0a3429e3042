// SPDX-License-Identifier: Apache-2.0
#include "report/printed_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/printed_pdf_test.h"

namespace dorsum {
namespace {

TEST(PaperTest, NamesInAnyCaseAndSidesInMillimetres) {
  EXPECT_EQ(ParsePaper("a3")->height_mm, 420.0);
  EXPECT_EQ(ParsePaper("LETTER")->width_mm, 215.9);
  EXPECT_EQ(ParsePaper("300x400.5")->height_mm, 400.5);
  EXPECT_EQ(ParsePaper("300X400")->width_mm, 300.0);
}

TEST(PaperTest, PaperThatNobodyHasIsAUsageErrorThatSaysWhatIsAllowed) {
  for (const char* text : {"", "A9", "x", "300", "300x", "x300", "nanx300", "infx300", "-300x400", "300x99",
                           "300x2001", "300x400mm", "1e999x300", "300x400x500", " 300x400"}) {
    const Result<Paper> paper = ParsePaper(text);
    ASSERT_FALSE(paper.ok()) << text;
    EXPECT_EQ(paper.error().code, ErrorCode::kUsage) << text;
    EXPECT_THAT(paper.error().message, testing::HasSubstr("A4")) << text;
  }
}

std::string SomePages(const std::string& title) {
  PrintedDocument document(title);
  document.BeginPage(100.0, 50.0);
  document.Text("words " + title, {10.0, 10.0}, {});
  document.BeginPage(60.0, 120.0);
  document.FillBox({Eigen::Vector2d(10.0, 20.0), Eigen::Vector2d(20.0, 40.0)}, 0.0);
  return document.Finish().value();
}

TEST(PrintedDocumentTest, TheSameDrawingIsTheSameBytesWithoutADate) {
  const std::string pdf = SomePages("four lasers");
  EXPECT_EQ(pdf, SomePages("four lasers"));
  EXPECT_EQ(pdf.find("Date"), std::string::npos);
  EXPECT_NE(pdf, SomePages("two lasers"));
}

TEST(PrintedDocumentTest, WordsInAnyLanguageAndBrokenTextDoNotStopIt) {
  EXPECT_FALSE(SomePages("Gerät \xF0\x9F\x96\x90").empty());
  EXPECT_FALSE(SomePages(std::string("\0\xff\xfe(\\)\n", 7)).empty());
}

TEST(PrintedDocumentTest, EachPageHasItsOwnSizeAndItsOriginBelowLeft) {
  const std::vector<cv::Mat> pages = DrawnPages(SomePages("test"), 254);
  ASSERT_EQ(pages.size(), 2U);
  EXPECT_NEAR(pages[0].cols, 1000, 1);
  EXPECT_NEAR(pages[0].rows, 500, 1);
  EXPECT_NEAR(pages[1].cols, 600, 1);
  EXPECT_NEAR(pages[1].rows, 1200, 1);
  EXPECT_EQ(pages[1].at<std::uint8_t>(1200 - 390, 110), 0);    // within the box from (10, 20) to (20, 40)
  EXPECT_EQ(pages[1].at<std::uint8_t>(1200 - 410, 110), 255);  // above it
  const double mm2 = (pages[1].total() - static_cast<double>(cv::countNonZero(pages[1]))) / 100.0;
  EXPECT_NEAR(mm2, 200.0, 1.0);
}

TEST(PrintedDocumentTest, WrappedLinesKeepAllWordsAndTheWidth) {
  PrintedDocument document("");
  const auto lines = document.Wrap("one two  three four five", 25.0, {});
  EXPECT_GT(lines.size(), 1U);
  std::string all;
  for (const std::string& line : lines) {
    EXPECT_LE(document.TextWidth(line, {}), 25.0);
    all += (all.empty() ? "" : " ") + line;
  }
  EXPECT_EQ(all, "one two three four five");
  EXPECT_EQ(document.Wrap("unbreakable", 1.0, {}).size(), 1U);
}

}  // namespace
}  // namespace dorsum
