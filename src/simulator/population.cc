// SPDX-License-Identifier: Apache-2.0
#include "simulator/population.h"

#include <algorithm>
#include <cmath>

namespace dorsum {

std::vector<Person> DrawPopulation(int people, int sessions) {
  constexpr double kWomen = 2.0 / 20.0;
  const int women = std::max(people >= 5 ? 1 : 0, static_cast<int>(std::lround(kWomen * people)));
  std::vector<Person> population;
  for (int i = 0; i < people; ++i) {
    Person person;
    person.id = (i < 10 ? "id0" : "id") + std::to_string(i);
    person.sex = (i + 1) * women / people > i * women / people ? Sex::kWoman : Sex::kMan;
    for (const Side side : {Side::kLeft, Side::kRight}) {
      for (int k = 0; k < sessions; ++k) {
        const std::string letter = side == Side::kLeft ? "L" : "R";
        person.captures.push_back({person.id + "_" + letter + "_k" + std::to_string(k), side, k});
      }
    }
    population.push_back(person);
  }
  return population;
}

SceneName SceneOf(const Person& person, const PersonCapture& capture) {
  SceneName name;
  name.kind = SceneName::Kind::kHand;
  name.sex = person.sex;
  name.side = capture.side;
  name.person = person.id;
  name.visit = capture.visit;
  name.geometry = name.folder = capture.folder;
  return name;
}

Json PeopleToJson(const std::vector<Person>& people) {
  Json json;
  json["schema"] = "dorsum.people";
  json["version"] = 1;
  json["people"] = Json::array();
  for (const Person& person : people) {
    Json entry;
    entry["id"] = person.id;
    entry["sex"] = person.sex == Sex::kMan ? "man" : "woman";
    entry["captures"] = Json::array();
    for (const PersonCapture& c : person.captures) {
      entry["captures"].push_back(
          {{"name", c.folder}, {"side", c.side == Side::kLeft ? "left" : "right"}, {"session", c.visit}});
    }
    json["people"].push_back(entry);
  }
  return json;
}

}  // namespace dorsum
