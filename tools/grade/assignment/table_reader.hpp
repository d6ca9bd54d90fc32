// A table of a TOML file, read key by key: wrong types, numbers out of range and unknown keys are told with their
// place.
#pragma once

#include <string>
#include <vector>

#include "scene/files/toml_tree.hpp"

namespace kreda::tools {

class TableReader {
public:
    /// `what` names the table in messages: "[[test]]".
    TableReader(const scene::Value& table, std::string what) : table_(table), what_(std::move(what)) {}

    void read(const std::string& key, std::string& result);
    void read(const std::string& key, double& result, double least, double most);
    void read(const std::string& key, int& result, int least, int most);
    void read(const std::string& key, bool& result);
    void read(const std::string& key, std::vector<std::string>& result);  ///< a text or an array of texts
    void read(const std::string& key, std::vector<double>& result);       ///< an array of numbers
    /// The tables of [[key]], or none.
    [[nodiscard]] std::vector<const scene::Value*> tables(const std::string& key);
    /// The table of [key], or null.
    [[nodiscard]] const scene::Value* table(const std::string& key);

    /// The key must be there.
    void require(const std::string& key) const;
    /// Every key of the table has been asked for; else complain about the first that was not.
    void done() const;
    [[noreturn]] void complain(const std::string& key, const std::string& message) const;

private:
    const scene::Value* find(const std::string& key, scene::ValueKind kind, const char* expected);
    const scene::Value& table_;
    std::string what_;
    std::vector<std::string> known_;
};

/// The whole of a file. Throws UserError.
[[nodiscard]] std::string read_text(const std::string& path);

}  // namespace kreda::tools
