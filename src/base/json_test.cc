// SPDX-License-Identifier: Apache-2.0
#include "base/json.h"

#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temp_folder_test.h"

namespace dorsum {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// What a reader says after `read` of an object.
std::string MessageOf(const std::string& object, const std::function<void(JsonReader&)>& read) {
  const Json json = Json::parse(object);
  JsonReader reader(json, "file.json");
  read(reader);
  if (reader.status().ok()) return "(no error)";
  EXPECT_EQ(reader.status().error().code, ErrorCode::kBadInput);
  return reader.status().error().message;
}

TEST(ReadJson, WhatIsNotJsonIsNamed) {
  const TempFolder folder;
  for (const char* text : {"", "{", "{\"a\": NaN}", "{\"a\": Infinity}", "{\"a\": -Infinity}",
                           "{\"a\": 1e999}", "{\"a\": 1} x", "{\"a\": \"\xff\"}", "\xef\xbb"}) {
    ASSERT_TRUE(WriteFile(folder / "file.json", text).ok());
    const auto json = ReadJson(folder / "file.json");
    ASSERT_FALSE(json.ok()) << text;
    EXPECT_EQ(json.error().code, ErrorCode::kBadInput);
    EXPECT_THAT(json.error().message, HasSubstr("file.json"));
  }
  ASSERT_TRUE(WriteFile(folder / "file.json", "{\"a\": NaN}").ok());
  EXPECT_THAT(ReadJson(folder / "file.json").error().message, HasSubstr("NaN"));
  EXPECT_FALSE(ReadJson(folder / "none.json").ok());
}

TEST(WriteJson, KeysKeepTheirOrderAndNumbersTheirValue) {
  const TempFolder folder;
  const Json json = {{"z", 0.1}, {"a", 1.0 / 3.0}, {"m", {1, 2}}};
  ASSERT_TRUE(WriteJson(folder / "file.json", json).ok());
  const Json back = ReadJson(folder / "file.json").value();
  EXPECT_EQ(back, json);
  EXPECT_EQ(back.begin().key(), "z");
}

TEST(WriteJson, AFileNameThatIsNotUtf8DoesNotThrow) {
  const TempFolder folder;
  ASSERT_TRUE(WriteJson(folder / "file.json", Json{{"name", "h\xe4nde.png"}}).ok());
  EXPECT_THAT(ReadJson(folder / "file.json").value()["name"].get<std::string>(), HasSubstr("nde.png"));
}

TEST(JsonReader, ReadsEachType) {
  const Json json =
      Json::parse(R"({"n": 1.5, "i": -3, "t": "x", "b": true, "l": [1, 2], "o": {"k": 1}, "a": [{}]})");
  JsonReader reader(json, "file.json");
  EXPECT_EQ(reader.Number("n"), 1.5);
  EXPECT_EQ(reader.Integer("i", -5, 5), -3);
  EXPECT_EQ(reader.Text("t"), "x");
  EXPECT_TRUE(reader.Bool("b"));
  EXPECT_EQ(reader.Numbers("l", 2), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(reader.Object("o").at("k"), 1);
  EXPECT_EQ(reader.Array("a", 1).size(), 1U);
  EXPECT_TRUE(reader.Has("n"));
  EXPECT_FALSE(reader.Has("none"));
  EXPECT_TRUE(reader.status().ok());
}

TEST(JsonReader, EachDamageNamesFileAndKey) {
  const auto names = [](const char* key) { return AllOf(HasSubstr("file.json"), HasSubstr(key)); };
  EXPECT_THAT(MessageOf("{}", [](auto& r) { r.Number("key"); }), AllOf(names("'key'"), HasSubstr("missing")));
  for (const char* value : {"\"1\"", "null", "[1]", "{}", "true"}) {
    const std::string object = std::string("{\"key\": ") + value + "}";
    EXPECT_THAT(MessageOf(object, [](auto& r) { r.Number("key"); }),
                AllOf(names("'key'"), HasSubstr("a number")));
    EXPECT_THAT(MessageOf(object, [](auto& r) { r.Integer("key", 0, 9); }), names("'key'"));
    EXPECT_THAT(MessageOf(object, [](auto& r) { r.Numbers("key", 3); }), names("'key'"));
  }
  EXPECT_THAT(MessageOf("{\"key\": 11}", [](auto& r) { r.Number("key", 0.0, 10.0); }),
              AllOf(names("'key'"), HasSubstr("between 0 and 10"), HasSubstr("11")));
  EXPECT_THAT(MessageOf("{\"key\": 1e300}", [](auto& r) { r.Integer("key", 0, 10); }), names("'key'"));
  EXPECT_THAT(MessageOf("{\"key\": 1.5}", [](auto& r) { EXPECT_EQ(r.Integer("key", 0, 10), 0); }),
              AllOf(names("'key'"), HasSubstr("whole number")));
  EXPECT_THAT(MessageOf("{\"key\": [1, null]}", [](auto& r) { r.Numbers("key"); }), names("'key'"));
  EXPECT_THAT(MessageOf("{\"key\": [1, 2]}", [](auto& r) { r.Numbers("key", 3); }),
              AllOf(names("'key'"), HasSubstr("list of 3")));
  EXPECT_THAT(MessageOf("{\"key\": 1}", [](auto& r) { r.Text("key"); }), names("'key'"));
  EXPECT_THAT(MessageOf("{\"key\": 1}", [](auto& r) { r.Bool("key"); }), names("'key'"));
  EXPECT_THAT(MessageOf("{\"key\": []}", [](auto& r) { r.Object("key"); }), names("'key'"));
  EXPECT_THAT(MessageOf("{\"key\": [1, 2]}", [](auto& r) { r.Array("key", 1); }), names("'key'"));
  EXPECT_THAT(MessageOf("[]", [](auto& r) { r.Number("key"); }), HasSubstr("object is expected"));
}

TEST(JsonReader, TheFirstErrorStaysAndLaterReadsGiveZero) {
  const Json json = Json::parse(R"({"good": 5, "list": [1, 2]})");
  JsonReader reader(json, "file.json");
  reader.Number("first");
  reader.Text("second");
  EXPECT_EQ(reader.Number("good"), 0.0);
  EXPECT_EQ(reader.Numbers("list", 2), (std::vector<double>{0.0, 0.0}));
  EXPECT_TRUE(reader.Array("list", 5).empty());
  EXPECT_THAT(reader.status().error().message, HasSubstr("'first'"));
}

TEST(JsonReader, AnErrorQuotesAForeignValueInPlainLetters) {
  const std::string message =
      MessageOf("{\"key\": \"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\u00e4\u00e4\u00e4\"}",
                [](auto& r) { r.Number("key"); });
  EXPECT_NO_THROW(static_cast<void>(Json(message).dump())) << "a character was cut in two";
}

TEST(JsonReader, OtherSchemasAndNewerVersionsAreRefused) {
  const auto check = [](auto& r) { r.Schema("dorsum/x", 2); };
  EXPECT_EQ(MessageOf(R"({"schema": "dorsum/x", "version": 1})", check), "(no error)");
  EXPECT_EQ(MessageOf(R"({"schema": "dorsum/x", "version": 2})", check), "(no error)");
  EXPECT_THAT(MessageOf(R"({"schema": "dorsum/x", "version": 3})", check), HasSubstr("newer"));
  EXPECT_THAT(MessageOf(R"({"schema": "dorsum/y", "version": 1})", check),
              AllOf(HasSubstr("not a dorsum/x file"), HasSubstr("dorsum/y")));
  EXPECT_THAT(MessageOf("{}", check), HasSubstr("not a dorsum/x file"));
  EXPECT_THAT(MessageOf(R"({"schema": "dorsum/x"})", check), HasSubstr("'version'"));
  EXPECT_THAT(MessageOf(R"({"schema": "dorsum/x", "version": 0})", check), HasSubstr("'version'"));
}

}  // namespace
}  // namespace dorsum
