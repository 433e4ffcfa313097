#include "python/Records.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>
#include <map>
#include <utility>

#include "analysis/OptionText.h"
#include "case/ShippedCases.h"
#include "core/Errors.h"
#include "python/Case.h"
#include "records/RecordReader.h"
#include "records/RowSource.h"
#include "records/SignalFaults.h"
#include "text/Csv.h"
#include "text/Heading.h"
#include "text/Numbers.h"

namespace squat::python {

namespace py = pybind11;

namespace {

// Rows that are copied block by block, as if from a file.
class ArrayRows : public records::RowSource {
 public:
  explicit ArrayRows(const ArrayRecord& record) : name_(record.name), columns_(record.columns) {
    head_.path = name_, head_.rowWord = "sample";
    for (const auto& column : columns_) {
      const auto heading = text::headingOf(column.heading);
      auto& own = head_.columns.emplace_back();
      own.name = heading.name, own.unit = heading.unit;
      append(column, 0, std::min(records::headRows, column.size), own.values);
    }
  }

  const text::DelimitedTable& head() const override { return head_; }
  std::string structure() const override { return "arrays, " + std::to_string(rows()) + " samples"; }
  void choose(std::vector<std::size_t> columns) override { chosen_ = std::move(columns); }
  bool next(std::size_t maximum, records::Rows& rows) override {
    const std::size_t end = std::min(read_ + maximum, this->rows());
    rows.columns.resize(chosen_.size());
    rows.lines.clear();
    rows.mistakes.clear();
    for (std::size_t c = 0; c < chosen_.size(); ++c) {
      rows.columns[c].clear();
      append(columns_[chosen_[c]], read_, end, rows.columns[c]);
    }
    const bool any = end > read_;
    read_ = end;
    return any;
  }
  double fraction() const override {
    return rows() > 0 ? static_cast<double>(read_) / static_cast<double>(rows()) : 1.0;
  }
  std::size_t rows() const override { return columns_.front().size; }
  std::vector<std::string> files() const override { return {name_}; }

 private:
  static void append(const ArrayColumn& column, std::size_t from, std::size_t end, std::vector<double>& values) {
    values.reserve(end - from);
    for (std::size_t i = from; i < end; ++i) values.push_back(column.at(i));
  }

  std::string name_;
  std::vector<ArrayColumn> columns_;
  text::DelimitedTable head_;
  std::vector<std::size_t> chosen_;
  std::size_t read_ = 0;
};

void addColumn(ArrayRecord& record, const std::string& heading, const py::object& values) {
  // Masked values are none: not-a-number.
  const auto plain = py::hasattr(values, "filled")
                         ? values.attr("astype")("float64").attr("filled")(std::numeric_limits<double>::quiet_NaN())
                         : values;
  auto array = py::array::ensure(plain);
  if (!array || std::string("fiu").find(array.dtype().kind()) == std::string::npos)
    throw CaseError({{heading, "no array of real numbers", "an array of floating-point or whole numbers", ""}});
  const bool isSingle = py::isinstance<py::array_t<float>>(array);
  if (!isSingle && !py::isinstance<py::array_t<double>>(array)) array = py::array_t<double>::ensure(array);
  if (array.ndim() != 1)
    throw CaseError({{heading, "an array of " + std::to_string(array.ndim()) + " dimensions", "one of one dimension",
                      "Give each channel as an array of its own"}});
  const auto size = static_cast<std::size_t>(array.size());
  if (!record.columns.empty() && size != record.columns.front().size)
    throw CaseError(
        {{heading, std::to_string(size) + " samples long",
          std::to_string(record.columns.front().size) + " samples long, as " + record.columns[0].heading, ""}});
  record.columns.push_back({heading, static_cast<const char*>(array.data()), array.strides(0), size, isSingle});
  record.owners.push_back(std::move(array));
}

// One for all signals that state none, or one for each column of a dict.
void takeUnits(readers::SignalFileOptions& reading, const py::handle& units) {
  if (!py::isinstance<py::dict>(units)) {
    reading.signalUnit = textOf(units);
    return;
  }
  for (const auto& [column, unit] : py::reinterpret_borrow<py::dict>(units))
    reading.units.emplace_back(textOf(column), textOf(unit));
}

}  // namespace

double ArrayColumn::at(std::size_t index) const {
  const char* place = data + static_cast<py::ssize_t>(index) * stride;
  if (isSingle) {
    float value = 0;
    std::memcpy(&value, place, sizeof value);
    return value;
  }
  double value = 0;
  std::memcpy(&value, place, sizeof value);
  return value;
}

bool isArrays(const py::object& object) { return py::isinstance<py::dict>(object) || py::hasattr(object, "__array__"); }

ArrayRecord arrayRecord(const std::string& name, const py::object& arrays) {
  ArrayRecord record;
  record.name = name;
  if (!py::isinstance<py::dict>(arrays))
    addColumn(record, "aba [m/s2]", arrays);
  else
    for (const auto& [heading, values] : py::reinterpret_borrow<py::dict>(arrays))
      addColumn(record, heading.cast<std::string>(), py::reinterpret_borrow<py::object>(values));
  if (record.columns.empty() || record.columns.front().size == 0)
    throw CaseError({{name, "empty", "at least one array with samples", ""}});
  return record;
}

std::unique_ptr<records::RecordStream> openArrays(const ArrayRecord& record, const records::RecordOptions& options) {
  readers::requireOptions(options.columns);
  return std::make_unique<records::CheckedRecord>(
      std::make_unique<records::RecordReader>(record.name, std::make_unique<ArrayRows>(record), options));
}

std::string csvOf(const ArrayRecord& record) {
  std::string text;
  for (const auto& column : record.columns) text += (text.empty() ? "" : ",") + text::csvField(column.heading);
  for (std::size_t i = 0; i < record.columns.front().size; ++i) {
    std::string row;
    for (const auto& column : record.columns) row += (row.empty() ? "" : ",") + text::numberText(column.at(i));
    text += "\n" + row;
  }
  return text + "\n";
}

std::string recordFile(const std::string& nameOrPath) {
  if (std::filesystem::exists(nameOrPath) || nameOrPath.find('/') != std::string::npos) return nameOrPath;
  const auto shipped = cases::resourcesFolder() / "records" / (nameOrPath + ".csv");
  return std::filesystem::exists(shipped) ? shipped.string() : nameOrPath;
}

readers::SignalFileOptions readingFrom(const py::kwargs& arguments) {
  using Reading = readers::SignalFileOptions;
  static const std::map<std::string, std::string Reading::*> texts{
      {"column", &Reading::column},
      {"time_column", &Reading::timeColumn},
      {"position_column", &Reading::positionColumn},
      {"speed_column", &Reading::speedColumn},
      {"run_column", &Reading::runColumn},
      {"object", &Reading::object},
      {"time_unit", &Reading::timeUnit},
  };
  Reading reading;
  for (const auto& [key, value] : arguments) {
    const auto name = key.cast<std::string>();
    if (const auto text = texts.find(name); text != texts.end())
      reading.*(text->second) = textOf(value);
    else if (name == "rate")
      reading.rate = value.cast<double>();
    else if (name == "speed")
      reading.speed = analysis::speedFromText(textOf(value));
    else if (name == "unit")
      takeUnits(reading, value);
    else if (name == "delimiter")
      reading.delimiter = analysis::delimiterFromText(textOf(value));
    else if (name == "decimal_comma")
      reading.decimal = value.cast<bool>() ? ',' : char{0};
    else if (name == "head_line")
      reading.headLine = value.cast<std::size_t>();
    else
      throw py::type_error("unexpected argument '" + name +
                           "'; arguments for reading are column, time_column, position_column, speed_column, "
                           "run_column, object, rate, speed, unit, time_unit, delimiter, decimal_comma and head_line");
  }
  return reading;
}

}  // namespace squat::python
