// SPDX-License-Identifier: Apache-2.0
#include "studio/campaign_view.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "jobs/campaign_disk.h"
#include "jobs/campaign_files.h"

namespace dorsum {
namespace {

using HandKey = std::tuple<std::string, int, CampaignHand>;

CampaignPersonView ViewPerson(CampaignPerson person, const CampaignPlan& plan,
                              const std::map<HandKey, CampaignHandView>& hands) {
  CampaignPersonView view{std::move(person), {}, 0, 0};
  std::set<int> sessions;
  for (int s = 1; s <= plan.sessions; ++s) sessions.insert(s);
  const HandKey first{view.person.id, 0, CampaignHand::kLeft};
  for (auto it = hands.lower_bound(first); it != hands.end() && std::get<0>(it->first) == view.person.id;
       ++it)
    sessions.insert(std::get<1>(it->first));
  for (const int number : sessions) {
    CampaignSessionView session{number, {}};
    for (const CampaignHand hand : {CampaignHand::kLeft, CampaignHand::kRight}) {
      const auto it = hands.find({view.person.id, number, hand});
      if (it == hands.end()) continue;
      session.hands.push_back(it->second);
      view.captures += static_cast<int>(it->second.captures.size());
      view.missing += it->second.missing;
    }
    if (!session.hands.empty()) view.sessions.push_back(std::move(session));
  }
  return view;
}

}  // namespace

Result<std::shared_ptr<const CampaignView>> ReadCampaignView(const std::filesystem::path& dir,
                                                             const Context& context) {
  auto view = std::make_shared<CampaignView>();
  // One moment of the campaign, whatever others write.
  DORSUM_ASSIGN_OR_RETURN(const CampaignLock lock,
                          CampaignLock::Take(dir, CampaignLock::Kind::kReader, context));
  DORSUM_ASSIGN_OR_RETURN(view->status, StatusOfCampaign(dir, {}, context));
  std::vector<std::string> told;  // by the status already
  DORSUM_ASSIGN_OR_RETURN(const std::vector<CampaignCapture> captures, ListCaptures(dir, &told));
  std::map<HandKey, CampaignHandView> hands;
  for (const CampaignCapture& c : captures) {
    CampaignHandView& hand = hands[{c.id, c.session, c.stored.hand}];
    hand.hand = c.stored.hand;
    hand.captures.push_back(c);
  }
  for (const MissingCaptures& m : view->status.missing) {
    CampaignHandView& hand = hands[{m.id, m.session, m.hand}];
    hand.hand = m.hand;
    hand.missing = m.count;
  }
  DORSUM_ASSIGN_OR_RETURN(const std::vector<std::string> people, ListPeople(dir));
  for (const std::string& id : people) {
    DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
    Result<CampaignPerson> person = ReadPerson(dir, id);
    if (!person.ok()) continue;
    view->people.push_back(ViewPerson(std::move(person).value(), view->status.campaign.plan, hands));
  }
  return std::shared_ptr<const CampaignView>(std::move(view));
}

const CampaignHandView* FindHand(const CampaignPersonView& person, int session, CampaignHand hand) {
  for (const CampaignSessionView& s : person.sessions) {
    if (s.number != session) continue;
    for (const CampaignHandView& h : s.hands) {
      if (h.hand == hand) return &h;
    }
  }
  return nullptr;
}

std::optional<MissingCaptures> NextMissing(const CampaignView& view, const CampaignPlace& place) {
  const auto& missing = view.status.missing;
  const auto it = std::find_if(missing.begin(), missing.end(), [&](const MissingCaptures& m) {
    return m.id == place.id && (place.session == 0 || m.session == place.session) &&
           (!place.hand || m.hand == *place.hand);
  });
  return it == missing.end() ? std::nullopt : std::optional(*it);
}

}  // namespace dorsum
