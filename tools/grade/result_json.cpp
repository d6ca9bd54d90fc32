// Kreda's own result file: written whole, read again by the class run.
#include <nlohmann/json.hpp>

#include "scene/error.hpp"
#include "tools/grade/plain_text.hpp"
#include "tools/grade/result_formats.hpp"

namespace kreda::tools {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;

Json json_of(const Measurement& measurement) {
    Json json = {{"name", plain_text(measurement.name)}, {"value", measurement.value}, {"ok", measurement.ok}};
    if (measurement.limit) json["limit"] = *measurement.limit;
    json["text"] = plain_text(measurement.text);
    return json;
}

Json json_of(const TestResult& test) {
    Json json = {{"name", plain_text(test.name)},
                 {"teaches", plain_text(test.teaches)},
                 {"points", test.points},
                 {"max_points", test.max_points},
                 {"passed", test.passed},
                 {"hidden", test.hidden},
                 {"message", plain_text(test.message)},
                 {"command", plain_text(test.command)}};
    json["measurements"] = Json::array();
    for (const Measurement& measurement : test.measurements) json["measurements"].push_back(json_of(measurement));
    return json;
}

std::optional<BoxTier> tier_named(const std::string& name) {
    for (const BoxTier tier : {BoxTier::bubblewrap, BoxTier::landlock, BoxTier::unsafe}) {
        if (name_of(tier) == name) return tier;
    }
    return std::nullopt;
}

TestResult test_of(const Json& json) {
    TestResult test;
    test.name = json.at("name");
    test.teaches = json.at("teaches");
    test.points = json.at("points");
    test.max_points = json.at("max_points");
    test.passed = json.at("passed");
    test.hidden = json.at("hidden");
    test.message = json.at("message");
    test.command = json.at("command");
    for (const Json& one : json.at("measurements")) {
        Measurement measurement{one.at("name"),
                                one.at("value").is_null() ? 0.0 : one.at("value").get<double>(),
                                {},
                                one.at("text"),
                                one.at("ok")};
        if (one.contains("limit") && one["limit"].is_number()) measurement.limit = one["limit"].get<double>();
        test.measurements.push_back(measurement);
    }
    return test;
}

}  // namespace

std::string result_json(const GradeResult& result, const std::string& key) {
    Json json = {{"format", kFormat},
                 {"key", key},
                 {"assignment", plain_text(result.assignment)},
                 {"submission", plain_text(result.submission)},
                 {"points", result.points},
                 {"max_points", result.max_points},
                 {"box", box_of(result)},
                 {"seconds", result.seconds},
                 {"diagnosis", plain_text(result.diagnosis)},
                 {"error", plain_text(result.error)},
                 {"tests", Json::array()}};
    for (const TestResult& test : result.tests) json["tests"].push_back(json_of(test));
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

StoredResult read_result_json(const std::string& text, const std::string& name) {
    try {
        const Json json = Json::parse(text);
        if (json.at("format") != kFormat) throw scene::UserError(scene::Place{name}, "is of another version of Kreda");
        StoredResult stored;
        stored.key = json.at("key");
        stored.result.assignment = json.at("assignment");
        stored.result.submission = json.at("submission");
        stored.result.points = json.at("points");
        stored.result.max_points = json.at("max_points");
        stored.result.tier = tier_named(json.at("box"));
        stored.result.seconds = json.at("seconds");
        stored.result.diagnosis = json.at("diagnosis");
        stored.result.error = json.at("error");
        for (const Json& test : json.at("tests")) stored.result.tests.push_back(test_of(test));
        return stored;
    } catch (const nlohmann::json::exception& error) {
        throw scene::UserError(scene::Place{name}, "is no result of kreda grade: " + std::string(error.what()));
    }
}

}  // namespace kreda::tools
