#include "receptance/ReceptanceFiles.h"

#include <algorithm>
#include <numbers>

#include "core/DurableFile.h"
#include "receptance/ThirdOctaves.h"
#include "results/Hdf5.h"
#include "text/Csv.h"

namespace squat::receptance {

namespace {

struct Parts {
  std::vector<double> real, imaginary, magnitude, phase;
};

Parts partsOf(const std::vector<std::complex<double>>& values) {
  Parts parts;
  for (const auto& value : values) {
    parts.real.push_back(value.real());
    parts.imaginary.push_back(value.imag());
    parts.magnitude.push_back(std::abs(value));
    parts.phase.push_back(std::arg(value) * 180 / std::numbers::pi);
  }
  return parts;
}

struct ModeColumns {
  std::vector<double> frequency, harmonic, antisymmetric, box, wheel, contact;
};

ModeColumns columnsOf(const std::vector<model::HarmonicMode>& modes) {
  ModeColumns columns;
  for (const auto& mode : modes) {
    columns.frequency.push_back(mode.frequency);
    columns.harmonic.push_back(mode.harmonic);
    columns.antisymmetric.push_back(mode.centre == model::Centre::antisymmetric ? 1 : 0);
    columns.box.push_back(mode.boxAmplitude);
    columns.wheel.push_back(mode.wheelAmplitude);
    columns.contact.push_back(mode.contactAmplitude);
  }
  return columns;
}

std::string groupName(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return "/" + name;
}

}  // namespace

void writeReceptance(const std::string& path, const TrackReceptance& receptance, const std::string& caseToml) {
  results::ArrayTree tree;
  results::setAttribute(tree.attributes, "schema", std::string("squat-receptance"));
  results::setAttribute(tree.attributes, "schema_version", std::int64_t{1});
  results::setAttribute(tree.attributes, "case", caseToml);
  results::setAttribute(tree.attributes, "how", receptance.how);
  results::setAttribute(tree.attributes, "unknowns", static_cast<std::int64_t>(receptance.unknowns));
  results::setAttribute(tree.attributes, "section_shapes", static_cast<std::int64_t>(receptance.sectionShapes));
  results::setAttribute(tree.attributes, "direct_solutions", static_cast<std::int64_t>(receptance.solutions));
  results::setAttribute(tree.attributes, "largest_difference", receptance.difference);
  results::setAttribute(tree.attributes, "elements", static_cast<std::int64_t>(receptance.elements));
  tree.add("/frequency", receptance.frequency, "Hz");
  for (const auto& point : receptance.points) {
    const auto parts = partsOf(point.receptance);
    const auto name = groupName(point.name);
    auto& group = tree.addGroup(name);
    results::setAttribute(group.attributes, "position", point.read);
    results::setAttribute(group.attributes, "struck", point.struck);
    results::setAttribute(group.attributes, "direction",
                          std::string(point.direction == RailDirection::vertical ? "vertical" : "lateral"));
    tree.add(name + "/real", parts.real, "m/N");
    tree.add(name + "/imaginary", parts.imaginary, "m/N");
  }
  const auto modes = columnsOf(receptance.modes);
  tree.add("/wheelset/frequency", modes.frequency, "Hz");
  tree.add("/wheelset/harmonic", modes.harmonic, "1");
  tree.add("/wheelset/antisymmetric", modes.antisymmetric, "1");
  tree.add("/wheelset/box", modes.box, "1/sqrt(kg)");
  tree.add("/wheelset/wheel", modes.wheel, "1/sqrt(kg)");
  tree.add("/wheelset/contact", modes.contact, "1/sqrt(kg)");
  writeDurably(path, results::encodeHdf5(tree, path));
}

std::string receptanceCsv(const TrackReceptance& receptance, ReceptanceQuantity quantity) {
  std::vector<std::string> names{"frequency [Hz]"};
  std::vector<const std::vector<double>*> columns{&receptance.frequency};
  std::vector<Parts> all;
  for (const auto& point : receptance.points)
    all.push_back(partsOf(asQuantity(receptance.frequency, point.receptance, quantity)));
  const std::string unit = std::string(" [").append(unitOf(quantity)).append("]");
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& name = receptance.points[i].name;
    for (const char* what : {" real", " imaginary", " magnitude"}) names.push_back(name + what + unit);
    names.push_back(name + " phase [deg]");
    for (const auto* column : {&all[i].real, &all[i].imaginary, &all[i].magnitude, &all[i].phase})
      columns.push_back(column);
  }
  return text::csvColumns(names, columns);
}

std::string thirdOctavesCsv(const TrackReceptance& receptance, ReceptanceQuantity quantity) {
  std::vector<std::string> names{"frequency [Hz]"};
  std::vector<ThirdOctaves> all;
  for (const auto& point : receptance.points) {
    all.push_back(thirdOctaves(receptance.frequency, asQuantity(receptance.frequency, point.receptance, quantity)));
    names.push_back(point.name + " [" + unitOf(quantity) + "]");
  }
  std::vector<const std::vector<double>*> columns{&all.front().band};
  for (const auto& bands : all) columns.push_back(&bands.value);
  return text::csvColumns(names, columns);
}

std::string modesCsv(const TrackReceptance& receptance) {
  const auto c = columnsOf(receptance.modes);
  return text::csvColumns({"frequency [Hz]", "harmonic", "antisymmetric", "box [1/sqrt(kg)]",
                           "wheel centre [1/sqrt(kg)]", "contact [1/sqrt(kg)]"},
                          {&c.frequency, &c.harmonic, &c.antisymmetric, &c.box, &c.wheel, &c.contact});
}

std::vector<std::string> receptanceFiles(const std::string& stem) {
  return {stem + "-receptance.h5", stem + "-receptance.csv", stem + "-receptance-third-octaves.csv",
          stem + "-wheelset-modes.csv"};
}

void writeReceptanceFiles(const std::string& stem, const TrackReceptance& receptance, const std::string& caseToml,
                          ReceptanceQuantity quantity) {
  const auto paths = receptanceFiles(stem);
  writeReceptance(paths[0], receptance, caseToml);
  writeDurably(paths[1], std::string_view(receptanceCsv(receptance, quantity)));
  writeDurably(paths[2], std::string_view(thirdOctavesCsv(receptance, quantity)));
  writeDurably(paths[3], std::string_view(modesCsv(receptance)));
}

}  // namespace squat::receptance
