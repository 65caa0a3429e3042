// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/json.h"
#include "simulator/named_scene.h"

namespace dorsum {

struct PersonCapture {
  std::string folder;  // id03_L_k0
  Side side = Side::kRight;
  int visit = 0;
};

struct Person {
  std::string id;  // id03
  Sex sex = Sex::kMan;
  std::vector<PersonCapture> captures;
};

// People in the document's proportion (§5.3: 18 men, 2 women), at least one woman among five or more, spread
// over the list; both hands, `sessions` captures each.
std::vector<Person> DrawPopulation(int people, int sessions);

SceneName SceneOf(const Person& person, const PersonCapture& capture);

// people.json: who is on which capture.
Json PeopleToJson(const std::vector<Person>& people);

}  // namespace dorsum
