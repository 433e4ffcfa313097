// A recording in the layout of the RCM-DX specification, chapters "Root" to "Position", made by HDF5's C interface: one
// session, axle box accelerations at 25 kHz, positions each 20 ms, a slower data source beside them.
#pragma once

#include <cmath>
#include <numbers>

#include "rcmdx/PlainHdf5.h"

namespace squat::tests {

struct SampleRecording {
  // Nanoseconds that a double does not hold: it would be off by up to 128 ns.
  static constexpr std::int64_t start = 1553237099123456789;
  static constexpr std::int64_t step = 40000;  // [ns] 25 kHz
  static constexpr std::size_t samples = 150000;
  static constexpr double speed = 30;           // [m/s]
  static constexpr double kilometre = 102.5;    // [km] on the line at the start; it falls
  static constexpr double trackLength = 120.0;  // [m] a new track begins each time

  std::string session = "/RCMDX/DFZ01/20190322_064459.123";
  bool prefixed = false;  // "data." before the names of positions, as SBB's files have it
  bool withLine = true;   // one line throughout; else it changes after two seconds
  bool withPositions = true;
  bool withCoordinates = false;
  std::string unit = "metre per second squared";

  static std::int64_t time(std::size_t i) { return start + static_cast<std::int64_t>(i) * step; }
  static float left(std::size_t i) { return static_cast<float>(i % 1001); }

  void write(const std::string& path) const {
    PlainHdf5 file(path, PlainHdf5::Open::made);
    writeHead(file);
    writeSession(file, session);
  }

  void writeHead(PlainHdf5& file) const {
    file.group("/RCMDX");
    for (const auto& [name, value] : {std::pair<const char*, std::int16_t>{"Major", 2}, {"Minor", 0}, {"Feature", 4}})
      file.attribute("/RCMDX", name, H5T_NATIVE_INT16, H5T_STD_I16LE, &value);
    file.element("/RCMDX/FILE", "File");
    file.text("/RCMDX/FILE", "StructureVersion", "7.1");
    file.element("/RCMDX/DFZ01", "Platform");
    file.text("/RCMDX/DFZ01", "VehicleNumber", "99 85 9160001-2");
  }

  void writeSession(PlainHdf5& file, const std::string& at) const {
    file.element(at, "Session");
    const std::uint64_t from = start - 5000, to = static_cast<std::uint64_t>(time(samples));
    file.attribute(at, "StartTime", H5T_NATIVE_UINT64, H5T_STD_U64LE, &from);
    file.attribute(at, "EndTime", H5T_NATIVE_UINT64, H5T_STD_U64LE, &to);
    file.group(at + "/CONFIGURATION");
    file.element(at + "/CONFIGURATION/TOPOLOGY", "Topology");
    file.element(at + "/CONFIGURATION/TOPOLOGY/LINE", "TopologyLine");
    const std::string front = prefixed ? "data." : "";
    file.dataset(at + "/CONFIGURATION/TOPOLOGY/LINE/" + front + "id", std::vector<std::int32_t>{710, 711},
                 H5T_NATIVE_INT32, H5T_STD_I32LE);
    file.texts(at + "/CONFIGURATION/TOPOLOGY/LINE/" + front + "name", {"Olten - Bern", "Bern - Thun"});
    writeAccelerations(file, at);
    if (withPositions) writePositions(file, at + "/POSITION");
  }

  void writeAccelerations(PlainHdf5& file, const std::string& at) const {
    const std::string system = at + "/DFZ01.ABA", fast = system + "/DFZ01.ABA.FAST", slow = system + "/DFZ01.ABA.SLOW";
    file.element(system, "System");
    file.element(fast, "Datasource");
    file.element(slow, "Datasource");
    std::vector<std::uint64_t> times(samples), slowTimes;
    std::vector<float> values(samples), opposite(samples), slowValues;
    std::vector<double> north, east;
    for (std::size_t i = 0; i < samples; ++i) {
      times[i] = static_cast<std::uint64_t>(time(i));
      values[i] = left(i), opposite[i] = -left(i);
      if (i % 10 != 0) continue;
      slowTimes.push_back(times[i]), slowValues.push_back(left(i));
      const double run = static_cast<double>(i) / static_cast<double>(samples);
      north.push_back(46.9 + 0.001 * run), east.push_back(7.4 - 0.002 * run);
    }
    file.dataset(fast + "/timestamp", times, H5T_NATIVE_UINT64, H5T_STD_U64LE);
    file.dataset(slow + "/timestamp", slowTimes, H5T_NATIVE_UINT64, H5T_STD_U64LE);
    writeChannel(file, fast, "DFZ01.ABA.FAST.ABA_LEFT", "MOVE_DIRECTION_VERTICAL_LEFT", 25000, unit, values);
    writeChannel(file, fast, "DFZ01.ABA.FAST.ABA_RIGHT", "MOVE_DIRECTION_VERTICAL_RIGHT", 25000, unit, opposite);
    writeChannel(file, fast, "DFZ01.ABA.FAST.TEMPERATURE", "TOTAL", 25000, "degree Celsius", values);
    writeChannel(file, slow, "DFZ01.ABA.SLOW.ACC_BODY", "TOTAL", 2500, "m/s2", slowValues);
    if (!withCoordinates) return;
    writeChannel(file, slow, "GPS_LATITUDE", "TOTAL", 2500, "degree", north);
    writeChannel(file, slow, "GPS_LONGITUDE", "TOTAL", 2500, "degree", east);
  }

  template <typename T>
  static void writeChannel(PlainHdf5& file, const std::string& source, const std::string& name, const char* basis,
                           float frequency, const std::string& unit, const std::vector<T>& values) {
    const std::string group = source + "/" + name;
    const float none = 0, offset = 1500;
    file.element(group, "Channel");
    file.text(group, "TriggerMode", "TIME");
    file.text(group, "ChannelBasis", basis);
    file.text(group, "MeasurementType", "MEASURED_VALUE");
    file.text(group, "Neighbor", "");
    file.attribute(group, "CommonTriggerDistance", H5T_NATIVE_FLOAT, H5T_IEEE_F32LE, &none);
    file.attribute(group, "CommonTriggerFrequency", H5T_NATIVE_FLOAT, H5T_IEEE_F32LE, &frequency);
    file.attribute(group, "PositionOffset", H5T_NATIVE_FLOAT, H5T_IEEE_F32LE, &offset);
    constexpr bool isFloat = sizeof(T) == 4;
    file.dataset(group + "/data", values, isFloat ? H5T_NATIVE_FLOAT : H5T_NATIVE_DOUBLE,
                 isFloat ? H5T_IEEE_F32LE : H5T_IEEE_F64LE);
    file.text(group + "/data", "Unit", unit);
  }

  void writePositions(PlainHdf5& file, const std::string& at) const {
    const std::string source = at + "/POSITION.SOURCE", data = source + "/POSITION.SOURCE.DATA";
    file.element(at, "System");
    file.element(source, "Datasource");
    file.group(data);
    std::vector<std::uint64_t> times;
    std::vector<double> covered, trackOffset, lineOffset;
    std::vector<std::int32_t> track, line, quality;
    std::vector<float> accuracy;
    std::vector<std::string> direction, kilometrage;
    constexpr std::size_t each = 500;  // samples
    for (std::size_t i = 0; i <= samples; i += each) {
      const double way = speed * static_cast<double>(i) / 25000;
      times.push_back(static_cast<std::uint64_t>(time(i)));
      covered.push_back(way);
      trackOffset.push_back(std::fmod(way, trackLength));
      track.push_back(40 + static_cast<std::int32_t>(way / trackLength));
      line.push_back(withLine || way < 2 * speed ? 710 : 711);
      lineOffset.push_back(kilometre - 1e-3 * way);
      accuracy.push_back(0.5f), quality.push_back(1);
      direction.push_back("BACKWARD"), kilometrage.push_back("DECREASING");
    }
    file.dataset(source + "/timestamp", times, H5T_NATIVE_UINT64, H5T_STD_U64LE);
    const std::string front = data + "/" + (prefixed ? "data." : "");
    file.dataset(front + "covereddistance", covered, H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE);
    file.texts(front + "direction", direction);
    file.texts(front + "kilometrage", kilometrage);
    file.dataset(front + "track_id", track, H5T_NATIVE_INT32, H5T_STD_I32LE);
    file.dataset(front + "line_id", line, H5T_NATIVE_INT32, H5T_STD_I32LE);
    file.dataset(front + "trackoffset", trackOffset, H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE);
    file.dataset(front + "lineoffset", lineOffset, H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE);
    file.dataset(front + "positionaccuracy", accuracy, H5T_NATIVE_FLOAT, H5T_IEEE_F32LE);
    file.dataset(front + "positionquality", quality, H5T_NATIVE_INT32, H5T_STD_I32LE);
  }
};

}  // namespace squat::tests
