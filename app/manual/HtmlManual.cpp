#include "manual/HtmlManual.h"

#include <md4c-html.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <functional>
#include <set>
#include <stdexcept>
#include <vector>

#include "core/DurableFile.h"
#include "text/HeadingAnchor.h"

namespace squat::manual {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestFile = std::size_t{16} << 20;

constexpr const char* kBeginning = R"(<!DOCTYPE html>
<html lang="en-GB">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Squat Studio VERSION: manual</title>
<style>
body { max-width: 60rem; margin: 0 auto; padding: 0 1rem 4rem; font: 1rem/1.5 sans-serif; color: #1a1a1a; }
section { border-top: 1px solid #b0b0b0; margin-top: 3rem; }
h1, h2, h3 { line-height: 1.25; }
code, pre { font-family: monospace; background: #f2f2f2; }
pre { padding: .6rem; overflow-x: auto; }
table { border-collapse: collapse; display: block; margin: 0.8em 0; overflow-x: auto; }
th, td { border: 1px solid #c8c8c8; padding: .25rem .5rem; text-align: left; vertical-align: top; }
img { max-width: 100%; }
nav { position: fixed; top: .5rem; right: 1rem; background: #fff; }
@media print { nav { display: none; } section { break-before: page; } }
</style>
</head>
<body>
<nav><a href="#manual">Contents</a></nav>
)";

struct Page {
  fs::path file;
  std::string id, html;
};

std::string rendered(const std::string& markdown) {
  std::string html;
  const auto append = [](const MD_CHAR* text, MD_SIZE size, void* to) {
    static_cast<std::string*>(to)->append(text, size);
  };
  if (md_html(markdown.data(), static_cast<MD_SIZE>(markdown.size()), append, &html, MD_DIALECT_GITHUB, 0) != 0)
    throw std::runtime_error("Markdown that cannot be rendered");
  return html;
}

// What stands between `open` and `close`, each time, becomes what `change` makes of it.
std::string changed(const std::string& text, const std::string& open, const std::string& close,
                    const std::function<std::string(const std::string&)>& change) {
  std::string result;
  std::size_t from = 0;
  for (auto at = text.find(open); at != std::string::npos; at = text.find(open, from)) {
    const auto begin = at + open.size(), end = text.find(close, begin);
    if (end == std::string::npos) break;
    result += text.substr(from, begin - from) + change(text.substr(begin, end - begin));
    from = end;
  }
  return result + text.substr(from);
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

std::string escaped(const std::string& text) { return replaced(replaced(text, "&", "&amp;"), "<", "&lt;"); }

// The text of a heading without tags and entities.
std::string wordsOf(const std::string& html) {
  std::string words;
  bool inTag = false;
  for (const char c : html) {
    if (c == '<') inTag = true;
    if (!inTag) words += c;
    if (c == '>') inTag = false;
  }
  for (const auto& [entity, sign] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}})
    words = replaced(words, entity, sign);
  return words;
}

std::string base64(const std::string& bytes) {
  using namespace boost::archive::iterators;
  using Sixes = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string text(Sixes(bytes.begin()), Sixes(bytes.end()));
  return text.append((3 - bytes.size() % 3) % 3, '=');
}

std::string idOf(const fs::path& file) {
  const auto name = file.extension() == ".md" ? file.stem().string() : file.filename().string();
  return text::headingAnchor(name == "README" ? file.parent_path().filename().string() : name);
}

class Manual {
 public:
  Manual(const fs::path& index, const fs::path& generated) : generated_(fs::weakly_canonical(generated)) {
    addPage(fs::weakly_canonical(index));
    pages_.front().id = "manual";
    std::vector<std::string> listed;
    changed(pages_.front().html, "href=\"", "\"", [&](const std::string& target) {
      listed.push_back(target.substr(0, target.find('#')));
      return target;
    });
    for (const auto& target : listed)
      if (target.ends_with(".md")) addPage(found(0, target));
    for (auto& page : pages_) addAnchors(page);
    for (std::size_t i = 0; i < pages_.size(); ++i) {  // grows by the files that are linked to
      const auto plain = pages_[i].html;
      auto html = changed(plain, "href=\"", "\"", [&](const std::string& target) { return link(i, target); });
      html = changed(html, "src=\"", "\"", [&](const std::string& target) { return picture(i, target); });
      pages_[i].html = std::move(html);
    }
  }

  std::string text(const std::string& version) const {
    std::string all = replaced(kBeginning, "VERSION", escaped(version));
    for (const auto& page : pages_) all += "<section id=\"" + page.id + "\">\n" + page.html + "</section>\n";
    return all + "<footer><p>Squat Studio " + escaped(version) + "</p></footer>\n</body>\n</html>\n";
  }

 private:
  [[noreturn]] void refuse(std::size_t page, const std::string& target) const {
    throw std::runtime_error(pages_[page].file.string() + ": there is no " + target);
  }

  const Page* pageOf(const fs::path& file) const {
    for (const auto& page : pages_)
      if (page.file == file) return &page;
    return nullptr;
  }

  void addPage(const fs::path& file) {
    if (!pageOf(file)) pages_.push_back({file, idOf(file), rendered(readWholeFile(file.string(), kLargestFile))});
  }

  fs::path found(std::size_t page, const std::string& target) const {
    const auto file = fs::weakly_canonical(pages_[page].file.parent_path() / target);
    const auto other = generated_ / file.filename();
    if (!fs::is_regular_file(file) && !fs::is_regular_file(other)) refuse(page, target);
    return fs::is_regular_file(file) ? file : other;
  }

  // Each heading gets the name by which links know it.
  void addAnchors(Page& page) {
    for (const char level : {'1', '2', '3', '4', '5', '6'}) {
      const auto end = std::string("</h") + level + ">";
      page.html = changed(page.html, std::string("<h") + level, end, [&](const std::string& rest) {
        const auto first = page.id + "--" + text::headingAnchor(wordsOf(rest.substr(1)));
        auto id = first;  // a second heading of the same words is "words-1"
        for (int i = 1; !anchors_.insert(id).second; ++i) id = first + "-" + std::to_string(i);
        return " id=\"" + id + "\"" + rest;
      });
    }
  }

  std::string link(std::size_t at, const std::string& target) {
    if (target.find(':') != std::string::npos) return target;
    const auto hash = target.find('#');
    const auto file = hash == 0 ? pages_[at].file : found(at, target.substr(0, hash));
    if (!pageOf(file))
      pages_.push_back({file, idOf(file),
                        "<h1>" + escaped(file.filename().string()) + "</h1>\n<pre>" +
                            escaped(readWholeFile(file.string(), kLargestFile)) + "</pre>\n"});
    const auto id = pageOf(file)->id;
    if (hash == std::string::npos) return "#" + id;
    const auto anchor = id + "--" + target.substr(hash + 1);
    if (!anchors_.contains(anchor)) refuse(at, target);
    return "#" + anchor;
  }

  std::string picture(std::size_t at, const std::string& target) const {
    const auto file = found(at, target);
    return "data:image/" + file.extension().string().substr(1) + ";base64," +
           base64(readWholeFile(file.string(), kLargestFile));
  }

  fs::path generated_;
  std::vector<Page> pages_;
  std::set<std::string> anchors_;
};

}  // namespace

std::string htmlManual(const fs::path& index, const fs::path& generated, const std::string& version) {
  return Manual(index, generated).text(version);
}

}  // namespace squat::manual
