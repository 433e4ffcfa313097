// The page resources/manual/files.md held against files that the programs have written.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace squat {

class FilesPage {
 public:
  // Throws where the page cannot be read.
  explicit FilesPage(const std::string& path);

  // Goes through every file below the folder. What the page does not say, one line each: a file that it does not know,
  // a column, key, dataset or attribute, a unit other than the page's.
  std::vector<std::string> notSaid(const std::string& folder);

  // The same of one table, as it would be written: `text` begins with its head.
  std::vector<std::string> notSaid(const std::string& section, const std::string& text);

  // The same of the keys of a JSON text, at any depth.
  std::vector<std::string> notSaidOfJson(const std::string& section, const std::string& text);

  // Columns, keys, datasets and attributes of the page that no file so far has shown. Sections of which no file was
  // seen are left out.
  std::vector<std::string> notSeen() const;

 private:
  struct Row {
    std::string unit;  // empty: any
    bool seen = false;
  };
  struct Section {
    std::map<std::string, Row> rows;
    std::string prose;  // what stands between heading and table
    bool seen = false;
  };
  void checkHead(const std::string& file, const std::string& section, const std::string& text);
  void checkKeys(const std::string& file, const std::string& section, const std::string& text);
  void checkArrays(const std::string& file, bool isResult);
  void see(const std::string& file, const std::string& section, const std::string& name, const std::string& unit);
  bool isPlaceholder(const Section& section, const std::string& name) const;

  std::map<std::string, Section> sections_;  // by heading
  std::string files_;                        // cells with the names of files
  std::vector<std::string> missing_;
};

}  // namespace squat
