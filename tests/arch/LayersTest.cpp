// The layers of the code and its other rules (CONTRIBUTING.md), held by reading the sources.
#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <map>
#include <regex>
#include <sstream>

#include "arch/SourceTree.h"

namespace squat::arch {
namespace {

using ::testing::IsEmpty;

using Folder = std::string;  // "solver/case", "widgets/scene", "app"
using Graph = std::map<Folder, std::set<Folder>>;

const std::vector<SourceFile>& sources() {
  static const auto files = readSources(SQUAT_SOURCE_DIR, {"solver", "widgets", "app", "python"});
  return files;
}

bool isQt(const std::string& include) {
  static const std::regex pattern("^(Q[A-Z][A-Za-z0-9]*(/.*)?|Qt[A-Z].*|qcustomplot\\.h|q[a-z]+\\.h)$");
  return std::regex_match(include, pattern);
}
bool isVtk(const std::string& include) { return include.rfind("vtk", 0) == 0; }

// "solver/case" for "case/CaseFile.h": own includes start at solver/, at widgets/ or at the top.
// The studio is large: each of its modules has a layer of its own.
Folder moduleOf(const std::string& path) { return path.substr(0, path.rfind('/')); }

// What only one system or compiler has stands below all else, in a folder of its own.
const Folder platform = "solver/core/platform";

Folder folderOf(const Include& include) {
  if (moduleOf("solver/" + include.name).starts_with(platform)) return platform;
  const auto first = include.name.substr(0, include.name.find('/'));
  if (first == "python") return "python";
  if (first == "app" || first == "commands" || first == "manual" || first == "pages") return "app";
  if (first == "studio") {
    const auto module = moduleOf("widgets/" + include.name);
    return module == "widgets/studio" ? "app" : module;  // without a module: the program's own files
  }
  for (const auto& file : sources())
    if (file.folder == first) return file.layer + "/" + first;
  return {};
}
Folder folderOf(const SourceFile& file) {
  auto module = moduleOf(file.path);
  if (module.starts_with(platform)) return platform;  // each system has a folder in it
  if (file.layer == "widgets" && file.folder == "studio") return module;
  return file.layer == "app" || file.layer == "python" ? file.layer : file.layer + "/" + file.folder;
}

// Every offence as "path includes name"; empty where the rule holds.
std::vector<std::string> offences(const std::function<bool(const SourceFile&, const Include&)>& forbidden) {
  std::vector<std::string> list;
  for (const auto& file : sources())
    for (const auto& include : file.includes)
      if (forbidden(file, include)) list.push_back(file.path + " includes " + include.name);
  return list;
}

Graph folderGraph() {
  Graph graph;
  for (const auto& file : sources())
    for (const auto& include : file.includes) {
      if (!include.quoted) continue;
      const auto target = folderOf(include);
      if (!target.empty() && target != folderOf(file)) graph[folderOf(file)].insert(target);
    }
  return graph;
}

// A cycle as "a -> b -> a"; empty where there is none.
std::string cycleIn(const Graph& graph) {
  std::map<Folder, int> state;  // 1 on the way, 2 done
  std::vector<Folder> way;
  std::string cycle;
  const std::function<void(const Folder&)> visit = [&](const Folder& folder) {
    state[folder] = 1;
    way.push_back(folder);
    if (const auto found = graph.find(folder); found != graph.end())
      for (const auto& next : found->second) {
        if (cycle.empty() && state[next] == 1) {
          for (auto step = std::find(way.begin(), way.end(), next); step != way.end(); ++step) cycle += *step + " -> ";
          cycle += next;
        }
        if (cycle.empty() && state[next] == 0) visit(next);
      }
    way.pop_back();
    state[folder] = 2;
  };
  for (const auto& [folder, ignored] : graph)
    if (state[folder] == 0) visit(folder);
  return cycle;
}

TEST(Layers, TheTreeWasRead) {
  EXPECT_GT(sources().size(), 20U);
  EXPECT_TRUE(folderGraph()["solver/simulation"].count("solver/results"));
  EXPECT_TRUE(folderGraph()["solver/core"].count(platform));
}

TEST(Layers, SolverKnowsNoQtAndNoVtk) {
  EXPECT_THAT(offences([](const SourceFile& file, const Include& include) {
                return file.layer == "solver" && (isQt(include.name) || isVtk(include.name));
              }),
              IsEmpty());
}

TEST(Layers, SolverSeesNeitherWidgetsNorApp) {
  EXPECT_THAT(offences([](const SourceFile& file, const Include& include) {
                const auto target = include.quoted ? folderOf(include) : Folder();
                return file.layer == "solver" &&
                       (target.rfind("widgets", 0) == 0 || target == "app" || target == "python");
              }),
              IsEmpty());
}

TEST(Layers, SignalsStandAlone) {
  EXPECT_THAT(offences([](const SourceFile& file, const Include& include) {
                if (file.path.rfind("solver/signals/", 0) != 0) return false;
                if (include.quoted) return include.name.rfind("signals/", 0) != 0;
                if (include.name == "fftw3.h") return !file.path.ends_with(".cpp");
                return include.name.find('.') != std::string::npos || include.name.find('/') != std::string::npos;
              }),
              IsEmpty());
}

TEST(Layers, StaticsAndDynamicsDoNotSeeEachOther) {
  EXPECT_THAT(offences([](const SourceFile& file, const Include& include) {
                return (file.folder == "statics" && include.name.rfind("dynamics/", 0) == 0) ||
                       (file.folder == "dynamics" && include.name.rfind("statics/", 0) == 0);
              }),
              IsEmpty());
}

TEST(Layers, WidgetsDoNotSeeTheApp) {
  EXPECT_THAT(offences([](const SourceFile& file, const Include& include) {
                return file.layer == "widgets" && include.quoted && folderOf(include) == "app";
              }),
              IsEmpty());
}

TEST(Layers, SceneKnowsNoQt) {
  EXPECT_THAT(offences([](const SourceFile& file, const Include& include) {
                return file.folder == "scene" && isQt(include.name);
              }),
              IsEmpty());
}

TEST(Layers, Hdf5StaysInResults) {
  EXPECT_THAT(offences([](const SourceFile& file, const Include& include) {
                return file.folder != "results" && (include.name == "hdf5.h" || include.name.rfind("H5", 0) == 0);
              }),
              IsEmpty());
}

// The layers, lowest first: a folder includes only what stands in a lower layer. Whoever computes stands below `case`,
// which is how a user writes what is simulated: it sees the scenario alone.
const std::vector<std::vector<Folder>>& layers() {
  static const std::vector<std::vector<Folder>> list{
      {platform},
      {"solver/core"},
      {"solver/text"},
      {"solver/signals"},
      {"solver/scenario"},
      {"solver/geometry"},
      {"solver/elasticity"},
      {"solver/forces"},
      {"solver/plasticity", "solver/contact"},
      {"solver/model"},
      {"solver/statics", "solver/dynamics"},
      {"solver/case"},
      {"solver/results"},
      {"solver/loggers", "solver/rcmdx"},
      {"solver/readers"},
      {"solver/records"},
      {"solver/analysis"},
      {"solver/project", "solver/receptance", "solver/simulation"},
      {"solver/studies", "solver/detection", "solver/roughness"},
      {"solver/growth"},
      {"solver/statements"},
      {"solver/calibration"},
      {"solver/estimation"},
      {"python"},
      {"widgets/colours"},
      {"widgets/scene"},
      {"widgets/plots"},
      {"widgets/studio/common"},
      {"widgets/studio/document"},
      {"widgets/studio/profile", "widgets/studio/runs"},
      {"widgets/studio/signals", "widgets/studio/model", "widgets/studio/preview", "widgets/studio/project",
       "widgets/studio/records"},
      {"widgets/studio/comparison"},
      {"widgets/studio/tools"},
      {"widgets/studio/window"},
      {"app"},
  };
  return list;
}

// Layer of a folder from below; -1: not on the list.
int layerOf(const Folder& folder) {
  for (std::size_t layer = 0; layer < layers().size(); ++layer)
    if (std::count(layers()[layer].begin(), layers()[layer].end(), folder) > 0) return static_cast<int>(layer);
  return -1;
}

// What is wrong with one include, and what to do; empty where nothing is.
std::string layerMistake(const std::string& path, const Folder& from, const std::string& include, const Folder& to) {
  const std::string says = path + " includes " + include + ": ";
  for (const auto& folder : {from, to})
    if (layerOf(folder) < 0) return says + folder + " is in no layer; give it one in layers() of tests/arch";
  if (from == to || layerOf(to) < layerOf(from)) return {};
  return says + to + " does not stand below " + from +
         "; pass a plain value up instead, or move what both need to a lower layer";
}

TEST(Layers, FoldersIncludeOnlyWhatStandsBelow) {
  std::vector<std::string> list;
  for (const auto& file : sources())
    for (const auto& include : file.includes) {
      const auto to = include.quoted ? folderOf(include) : Folder();
      if (to.empty()) continue;
      if (const auto mistake = layerMistake(file.path, folderOf(file), include.name, to); !mistake.empty())
        list.push_back(mistake);
    }
  EXPECT_THAT(list, IsEmpty());
}

TEST(Layers, AnIncludeUpwardsOrOfAnUnknownFolderSaysWhatToDo) {
  EXPECT_EQ(layerMistake("solver/model/A.cpp", "solver/model", "scenario/Track.h", "solver/scenario"), "");
  EXPECT_EQ(layerMistake("solver/model/A.cpp", "solver/model", "model/B.h", "solver/model"), "");
  EXPECT_THAT(layerMistake("solver/model/A.cpp", "solver/model", "case/CaseFile.h", "solver/case"),
              ::testing::HasSubstr("pass a plain value up"));
  EXPECT_THAT(layerMistake("solver/statics/A.cpp", "solver/statics", "dynamics/B.h", "solver/dynamics"),
              ::testing::HasSubstr("does not stand below"));
  EXPECT_THAT(layerMistake("solver/attic/A.cpp", "solver/attic", "core/Errors.h", "solver/core"),
              ::testing::HasSubstr("solver/attic is in no layer"));
}

TEST(Layers, FoldersFormNoCycle) { EXPECT_EQ(cycleIn(folderGraph()), ""); }

TEST(Layers, NoFileIsLongerThan500Lines) {
  std::vector<std::string> list;
  for (const auto& file : readSources(SQUAT_SOURCE_DIR, {"solver", "widgets", "app", "python", "tests"}))
    if (file.lines > 500) list.push_back(file.path + ": " + std::to_string(file.lines));
  EXPECT_THAT(list, IsEmpty());
}

// A function of the sources, found by the layout: its first line and its closing brace start in one column, in column 2
// for a member written inside its class. Blocks of a function that stand there are shorter than it.
std::vector<std::string> longFunctions(const SourceFile& file, std::size_t maximum) {
  struct Opening {
    std::size_t number = 1;
    std::string line;
  };
  std::map<std::size_t, Opening> openings;  // by column
  std::vector<std::string> found;
  std::istringstream text(file.code);
  std::string line;
  for (std::size_t number = 1; std::getline(text, line); ++number) {
    const auto column = line.find_first_not_of(' ');
    if (column != 0 && column != 2) continue;
    const auto content = line.substr(column);
    auto& opening = openings[column];
    if (content == "}") {
      if (number - opening.number + 1 > maximum) found.push_back(file.path + ": " + opening.line);
    } else if (content[0] != '}' && content[0] != '#') {
      opening = {number, content};
    }
  }
  return found;
}

TEST(Layers, NoFunctionOfTheSolverIsLongerThan80Lines) {
  std::vector<std::string> list;
  for (const auto& file : sources())
    if (file.layer == "solver")
      for (auto& function : longFunctions(file, 80)) list.push_back(std::move(function));
  EXPECT_THAT(list, IsEmpty());
}

TEST(LongFunctions, AreFound) {
  SourceFile file;
  file.path = "some.cpp";
  file.code = "namespace a {\nint f(int x,\n      int y) {\n  if (x) {\n  }\n  return y;\n}\nint g() {\n}\n}  \n";
  EXPECT_THAT(longFunctions(file, 5), ::testing::ElementsAre("some.cpp: int f(int x,"));
  EXPECT_THAT(longFunctions(file, 6), IsEmpty());
  file.code = "class C {\n public:\n  C()\n      : x_(1) {\n    if (x_) {\n    }\n  }\n  int x_;\n};\n";
  EXPECT_THAT(longFunctions(file, 4), ::testing::ElementsAre("some.cpp: C()"));
  EXPECT_THAT(longFunctions(file, 5), IsEmpty());
}

TEST(Layers, TheDefectSurfaceIsBuiltInOnePlace) {
  static const std::regex construction(R"(\bDefectSurface\s*(\w+\s*)?[({]\s*[a-zA-Z*])");
  std::vector<std::string> list;
  for (const auto& file : sources())
    if (file.folder != "scenario" && file.path.rfind("solver/case/Resolve.", 0) != 0 &&
        std::regex_search(file.code, construction))
      list.push_back(file.path + ": ask cases::surfaceOf() or the scenario for it");
  EXPECT_THAT(list, IsEmpty());
}

TEST(Layers, TheSolverNeverPrintsAbortsOrExits) {
  static const std::regex pattern(
      R"(\b(std::cout|std::cerr|std::clog|printf|fprintf|puts|abort|std::terminate|assert|exit|quick_exit)\s*(\(|<<))");
  std::vector<std::string> list;
  for (const auto& file : sources())
    if (std::smatch match; file.layer == "solver" && std::regex_search(file.code, match, pattern))
      list.push_back(file.path + ": " + match.str());
  EXPECT_THAT(list, IsEmpty());
}

TEST(Layers, EveryHeaderIsIncludedOnce) {
  std::vector<std::string> list;
  for (const auto& file : sources())
    if (file.path.ends_with(".h") && file.code.find("#pragma once") == std::string::npos) list.push_back(file.path);
  EXPECT_THAT(list, IsEmpty());
}

TEST(CycleSearch, FindsACycleAndOnlyACycle) {
  EXPECT_EQ(cycleIn({{"a", {"b", "c"}}, {"b", {"c"}}}), "");
  EXPECT_EQ(cycleIn({{"a", {"b"}}, {"b", {"c"}}, {"c", {"b"}}}), "b -> c -> b");
}

TEST(CommentStripper, LeavesOnlyCode) {
  EXPECT_EQ(withoutComments("int a; // exit(1)\nint b; /* abort() */ f(\"exit(1)\", '\"');"),
            "int a; \nint b;  f(, );");
}

}  // namespace
}  // namespace squat::arch
