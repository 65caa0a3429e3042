// SPDX-License-Identifier: Apache-2.0
#include "studio/campaign_table.h"

#include <QSignalSpy>
#include <QTableView>
#include <QTest>

#include "jobs/campaign_fixture_test.h"
#include "studio/campaign_filter.h"
#include "studio/patience_test.h"

namespace dorsum {
namespace {

class CampaignTableTest : public CampaignFixture {
 protected:
  void Show() {
    const auto view = ReadCampaignView(dir_, {});
    ASSERT_TRUE(view.ok()) << view.error().message;
    table_.SetView(*view, dir_);
  }
  QString Text(const CampaignPlace& place) { return table_.IndexOf(place).data().toString(); }

  CampaignThumbnails thumbnails_{64};
  CampaignTable table_{&thumbnails_};
};

TEST_F(CampaignTableTest, EachHandOfEachSessionSaysWhatIsThereAndWhatIsMissing) {
  ASSERT_TRUE(Person("p02", "woman").ok());
  ASSERT_TRUE(Capture(1).ok());
  ASSERT_TRUE(Capture(2, "p02").ok());
  ASSERT_TRUE(Capture(3, "p02").ok());
  Show();
  ASSERT_EQ(table_.rowCount(), 2);
  ASSERT_EQ(table_.columnCount(), 3 + 4);
  EXPECT_EQ(Text({"p01", 1, CampaignHand::kLeft}), "1 of 2");
  EXPECT_EQ(Text({"p01", 2, CampaignHand::kRight}), "0 of 2");
  EXPECT_TRUE(Text({"p02", 1, CampaignHand::kLeft}).startsWith(QChar(0x2713)));
  EXPECT_EQ(table_.IndexOf({"p02", 0, {}}).siblingAtColumn(1).data().toString(), "woman");
  EXPECT_EQ(table_.IndexOf({"p01", 0, {}}).data(CampaignTable::kMissingRole).toInt(), 7);
  EXPECT_FALSE(table_.IndexOf({"p03", 0, {}}).isValid());
  EXPECT_TRUE(table_.IndexOf({"p01", 1, CampaignHand::kLeft})
                  .data(Qt::AccessibleTextRole)
                  .toString()
                  .contains("1 captures are there, 1 are missing"));
  EXPECT_EQ(table_.CapturesAt(table_.IndexOf({"p02", 0, {}})).size(), 2U);
  const auto gap = table_.NextGap(table_.IndexOf({"p01", 2, CampaignHand::kRight}));
  ASSERT_TRUE(gap);
  EXPECT_EQ(gap->id, "p02");
  EXPECT_EQ(gap->hand, CampaignHand::kRight) << "its left hand has all";
}

TEST_F(CampaignTableTest, APictureComesBesideTheWindowAndOneThatIsDamagedStaysAway) {
  ASSERT_TRUE(Capture(1).ok());
  ASSERT_TRUE(Capture(2, "p01", CampaignHand::kRight).ok());
  const auto right = CaptureFolder(dir_, "p01", 1, {CampaignHand::kRight, 1});
  ASSERT_TRUE(WriteFile(right / "bgHand.png", "no picture").ok());
  Show();
  const QModelIndex left = table_.IndexOf({"p01", 1, CampaignHand::kLeft});
  EXPECT_FALSE(left.data(Qt::DecorationRole).isValid()) << "nothing is read in the window's thread";
  QSignalSpy changed(&table_, &QAbstractItemModel::dataChanged);
  ASSERT_TRUE(QTest::qWaitFor([&] { return left.data(Qt::DecorationRole).isValid(); }, kPatience_ms));
  EXPECT_GE(changed.count(), 1);
  QSignalSpy made(&thumbnails_, &CampaignThumbnails::Made);
  const QModelIndex damaged = table_.IndexOf({"p01", 1, CampaignHand::kRight});
  static_cast<void>(damaged.data(Qt::DecorationRole));
  ASSERT_TRUE(made.wait(kPatience_ms));
  EXPECT_FALSE(damaged.data(Qt::DecorationRole).isValid());
  EXPECT_EQ(thumbnails_.open_wishes(), 0U) << "it is not tried for ever";
}

TEST_F(CampaignTableTest, ARetakenCaptureGetsItsOwnPicture) {
  ASSERT_TRUE(Capture(1).ok());
  QImage first, second;
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return !(first = thumbnails_.Want(Folder(), "one")).isNull(); }, kPatience_ms));
  WriteNoiseCapture(Folder(), 77);
  EXPECT_EQ(thumbnails_.Want(Folder(), "one"), first);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return !(second = thumbnails_.Want(Folder(), "two")).isNull(); }, kPatience_ms));
  EXPECT_NE(first, second);
}

TEST_F(CampaignTableTest, OnlyTheLatestPicturesAreKept) {
  ASSERT_TRUE(Capture(1).ok());
  ASSERT_TRUE(Capture(2).ok());
  CampaignThumbnails few(32, 1);
  const auto wait = [&](int number) {
    return QTest::qWaitFor([&] { return !few.Want(Folder(number), "").isNull(); }, kPatience_ms);
  };
  ASSERT_TRUE(wait(1));
  ASSERT_TRUE(wait(2));
  EXPECT_TRUE(few.Want(Folder(1), "").isNull());
}

// A thousand people with two sessions: what is not seen costs nothing.
TEST_F(CampaignTableTest, AThousandPeopleAreShownWithoutReadingTheirPictures) {
  CampaignView view;
  view.status.campaign.plan.sessions = 2;
  for (int i = 0; i < 1000; ++i) {
    CampaignPersonView person;
    person.person.id = "p" + std::to_string(1000 + i);
    for (int s = 1; s <= 2; ++s) {
      CampaignHandView left{CampaignHand::kLeft, {}, i % 2}, right{CampaignHand::kRight, {}, 0};
      for (CampaignHandView* hand : {&left, &right})
        hand->captures.push_back({person.person.id, s, {hand->hand, 1, "", {0}, {{"bgHand.png", 9, "x"}}}});
      person.sessions.push_back({s, {left, right}});
      person.missing += i % 2;
    }
    view.people.push_back(person);
  }
  CampaignFilter filter;
  filter.setSourceModel(&table_);
  QTableView window;
  window.setModel(&filter);
  window.setSortingEnabled(true);
  window.resize(900, 600);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  table_.SetView(std::make_shared<const CampaignView>(std::move(view)), "/nowhere");
  EXPECT_EQ(filter.rowCount(), 1000);
  QTest::qWait(20);
  EXPECT_LT(thumbnails_.open_wishes(), 257U);
  filter.SetOnlyMissing(true);
  EXPECT_EQ(filter.rowCount(), 500);
  filter.SetText("p1999");
  ASSERT_EQ(filter.rowCount(), 1);
  EXPECT_EQ(filter.index(0, 0).data().toString(), "p1999");
}

}  // namespace
}  // namespace dorsum
