// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// How fast recordings of each format are listed and read, all channels with all fields, over a
// plain read of the same file; a bag over ROS's rosbag, and a DataFlash log over a reader in plain
// Python (peers/); the peak memory of fathom_import with bags of 2 GB. Exit 1 if a limit is broken.
// Times are CPU times, ours the best of two runs, of files that the system holds in memory.
//
//   build/release/bench/import_bench

#include "fathom/import/open_recording.h"
#include "fathom/process/run_child.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "dataflash_writer.h"
#include "tlog_writer.h"
#include "ulog_writer.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <lz4frame.h>
#include <unistd.h>
#include <zstd.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;
using dataflash::Bytes;

constexpr double kLeastSpeed = 30.0;  // listing and reading, of files not compressed [MB/s]
constexpr double kLeastOverPython = 30.0;
constexpr double kMostMemory = 300.0;  // [MB]
constexpr std::uint64_t kFileSize = 64'000'000;
constexpr std::uint64_t kLargeBag = 2'000'000'000;
constexpr std::size_t kChunkSize = std::size_t{1} << 20;

bool Report(const std::string& what,
            double value,
            const std::string& unit,
            bool holds,
            const std::string& limit) {
  fmt::print("{:<66} {:>7.1f} {:<4} {:<12} {}\n", what, value, unit, limit, holds ? "" : "BROKEN");
  std::fflush(stdout);
  return holds;
}

double CpuSecondsOf(const std::function<void()>& action) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 2; ++i) {
    const std::clock_t start = std::clock();
    action();
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

// --- Files

// A file of a head and as many copies of a block as make `size` bytes.
fs::path WriteTiled(const fs::path& path,
                    const std::string& head,
                    const std::string& block,
                    std::uint64_t size = kFileSize) {
  std::ofstream file(path, std::ios::binary);
  file << head;
  for (std::uint64_t done = head.size(); done < size; done += block.size()) file << block;
  return path;
}

// So many messages one behind the other.
std::string Repeated(int count, const std::function<std::string(int)>& message) {
  std::string block;
  for (int k = 0; k < count; ++k) block += message(k);
  return block;
}

fs::path WriteCsv(const fs::path& path) {
  std::ofstream file(path, std::ios::binary);
  file << "time [s],x [m],y [m],z [m],roll [deg],pitch [deg],yaw [deg]\n";
  fmt::memory_buffer rows;
  for (int k = 0; file.tellp() < static_cast<std::streamoff>(kFileSize); ++k) {
    const double s = std::sin(0.01 * k);
    fmt::format_to(std::back_inserter(rows),
                   "{:.3f},{:.6f},{:.6f},{:.6f},{:.4f},{:.4f},{:.4f}\n",
                   0.01 * k,
                   s,
                   2.0 * s,
                   -s,
                   10.0 * s,
                   3.0 * s,
                   180.0 * s);
    if (rows.size() < kChunkSize) continue;
    file.write(rows.data(), static_cast<std::streamsize>(rows.size()));
    rows.clear();
  }
  return path;
}

fs::path WriteDataflash(const fs::path& path) {
  return WriteTiled(path,
                    dataflash::FmtOfAtt() + dataflash::Fmt(11,
                                                           47,
                                                           "IMU",
                                                           "QffffffIIf",
                                                           "TimeUS,GyrX,GyrY,GyrZ,AccX,AccY,AccZ,"
                                                           "EG,EA,T"),
                    Repeated(10000, [](int k) {
                      const auto time = static_cast<std::uint64_t>(2500 * k);
                      return dataflash::Att(time, 0.01 * k, k, 0.5F) +
                             dataflash::Message(11,
                                                Bytes(time) + Bytes(0.1F) + Bytes(0.2F) +
                                                    Bytes(0.3F) + Bytes(0.4F) + Bytes(0.5F) +
                                                    Bytes(9.8F) + Bytes(k) + Bytes(k) +
                                                    Bytes(20.0F));
                    }));
}

fs::path WriteUlog(const fs::path& path) {
  return WriteTiled(path, ulog::Header() + ulog::Attitude(), Repeated(10000, [](int k) {
                      return ulog::Attitude(static_cast<std::uint64_t>(2500 * k), 0.9F, k % 256);
                    }));
}

fs::path WriteTlog(const fs::path& path) {
  return WriteTiled(path, "", Repeated(10000, [](int k) {
                      return tlog::Attitude(1500000000000000U + 2500U * k, 0.1F * k);
                    }));
}

std::string Counted(const std::string& text) {
  return Bytes(static_cast<std::uint32_t>(text.size())) + text;
}

std::string Block(char kind, const std::string& payload) {
  return std::string{kind, '\xff'} + Bytes<std::uint16_t>(0) + Counted(payload);
}

fs::path WritePocolog(const fs::path& path) {
  const std::string types =
      "<?xml version=\"1.0\"?>\n<typelib>\n"
      "<numeric name=\"/double\" category=\"float\" size=\"8\"/>\n"
      "<compound name=\"/Pose\" size=\"48\"><field name=\"position\" type=\"/double[3]\" "
      "offset=\"0\"/><field name=\"angles\" type=\"/double[3]\" offset=\"24\"/></compound>\n"
      "</typelib>\n";
  return WriteTiled(
      path,
      std::string("POCOSIM\0", 8) + Bytes(2) + Bytes(0) +
          Block(1,
                '\1' + Counted("/pose") + Counted("/Pose") + Counted(types) + Counted("--- {}\n")),
      Repeated(10000, [](int k) {
        const std::string time = Bytes(1500000000 + k / 100) + Bytes(k % 100 * 10000);
        std::string pose;
        for (int i = 0; i < 6; ++i) pose += Bytes(0.01 * k + i);
        return Block(2, time + time + Bytes<std::uint32_t>(48) + '\0' + pose);
      }));
}

// --- Messages of ROS

constexpr char kOdometry[] =
    "Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n"
    "geometry_msgs/TwistWithCovariance twist\n===\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\n"
    "string frame_id\n===\nMSG: geometry_msgs/PoseWithCovariance\nPose pose\n"
    "float64[36] covariance\n===\nMSG: geometry_msgs/Pose\nPoint position\nQuaternion "
    "orientation\n===\nMSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z\n===\n"
    "MSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n===\n"
    "MSG: geometry_msgs/TwistWithCovariance\nTwist twist\nfloat64[36] covariance\n===\n"
    "MSG: geometry_msgs/Twist\nVector3 linear\nVector3 angular\n===\n"
    "MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n";

constexpr char kImage[] =
    "Header header\nuint32 height\nuint32 width\nstring encoding\nuint8 is_bigendian\nuint32 step\n"
    "uint8[] data\n===\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n";

constexpr char kWrench[] =
    "Header header\ngeometry_msgs/Wrench wrench\n===\nMSG: std_msgs/Header\nuint32 seq\ntime "
    "stamp\nstring frame_id\n===\nMSG: geometry_msgs/Wrench\nVector3 force\nVector3 torque\n===\n"
    "MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n";

std::string Numbers(int count, int k) {
  std::string bytes;
  for (int i = 0; i < count; ++i) bytes += Bytes(std::sin(0.01 * k + i));
  return bytes;
}

std::string Ros1Header(std::uint32_t seconds, std::uint32_t nanoseconds) {
  return Bytes<std::uint32_t>(0) + Bytes(seconds) + Bytes(nanoseconds) + Counted("odom");
}

std::string Ros1Odometry(int k) {
  return Ros1Header(1500000000 + k / 100, k % 100 * 10000000U) + Counted("base") + Numbers(85, k);
}

std::string CdrOdometry(int k) {
  // Its numbers stand at a multiple of 8.
  return std::string("\0\1\0\0", 4) + Bytes(1500000000 + k / 100) + Bytes(k % 100 * 10000000) +
         Counted(std::string("odo\0", 4)) + Counted(std::string("bas\0", 4)) + Numbers(85, k);
}

std::string Compressed(const std::string& compression, const std::string& text) {
  std::string out;
  if (compression == "lz4") {
    out.resize(LZ4F_compressFrameBound(text.size(), nullptr));
    out.resize(LZ4F_compressFrame(out.data(), out.size(), text.data(), text.size(), nullptr));
  } else if (compression == "zstd") {
    out.resize(ZSTD_compressBound(text.size()));
    out.resize(ZSTD_compress(out.data(), out.size(), text.data(), text.size(), 3));
  } else {
    out = text;
  }
  return out;
}

std::string McapRecord(char op, const std::string& content) {
  return std::string(1, op) + Bytes(static_cast<std::uint64_t>(content.size())) + content;
}

fs::path WriteMcap(const fs::path& path, const std::string& compression) {
  std::string definition = kOdometry;
  definition.erase(definition.find("uint32 seq\n"), 11);  // which ROS 2 has not
  definition.replace(definition.find("time stamp"), 10, "builtin_interfaces/Time stamp");
  definition.replace(0, 6, "std_msgs/Header");
  definition += "===\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n";
  const std::string head = "\x89MCAP0\r\n" + McapRecord(1, Counted("ros2") + Counted("bench")) +
                           McapRecord(3,
                                      Bytes<std::uint16_t>(1) + Counted("nav_msgs/msg/Odometry") +
                                          Counted("ros2msg") + Counted(definition)) +
                           McapRecord(4,
                                      Bytes<std::uint16_t>(1) + Bytes<std::uint16_t>(1) +
                                          Counted("/odom") + Counted("cdr") + Counted(""));
  const std::string records = Repeated(1400, [](int k) {
    const auto time = 1500000000000000000U + 10000000U * static_cast<std::uint64_t>(k);
    return McapRecord(
        5, Bytes<std::uint16_t>(1) + Bytes(k) + Bytes(time) + Bytes(time) + CdrOdometry(k));
  });
  const std::string stored = Compressed(compression, records);
  return WriteTiled(path,
                    head,
                    McapRecord(6,
                               Bytes<std::uint64_t>(0) + Bytes<std::uint64_t>(1) +
                                   Bytes(static_cast<std::uint64_t>(records.size())) +
                                   Bytes<std::uint32_t>(0) + Counted(compression) +
                                   Bytes(static_cast<std::uint64_t>(stored.size())) + stored));
}

fs::path WriteDatabase(const fs::path& path) {
  SQLite::Database database(path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  database.exec("CREATE TABLE topics (id INTEGER PRIMARY KEY, name TEXT, type TEXT)");
  database.exec(
      "CREATE TABLE messages (id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data "
      "BLOB)");
  database.exec("INSERT INTO topics VALUES (1, '/odom', 'nav_msgs/msg/Odometry')");
  SQLite::Transaction transaction(database);
  SQLite::Statement insert(database,
                           "INSERT INTO messages (topic_id, timestamp, data) VALUES (1, ?, ?)");
  const std::uint64_t count = kFileSize / CdrOdometry(0).size();
  for (std::uint64_t k = 0; k < count; ++k) {
    const std::string message = CdrOdometry(static_cast<int>(k));
    insert.bind(1, static_cast<std::int64_t>(1500000000000000000U + 10000000U * k));
    insert.bind(2, message.data(), static_cast<int>(message.size()));
    insert.exec();
    insert.reset();
  }
  transaction.commit();
  return path;
}

std::string BagRecord(const std::vector<std::pair<std::string, std::string>>& fields,
                      const std::string& data) {
  std::string header;
  for (const auto& field : fields) header += Counted(field.first + "=" + field.second);
  return Counted(header) + Counted(data);
}

std::string BagConnection(int number,
                          const std::string& topic,
                          const std::string& type,
                          const std::string& definition) {
  return BagRecord({{"conn", Bytes(number)}, {"op", "\x07"}, {"topic", topic}},
                   Counted("type=" + type) + Counted("message_definition=" + definition));
}

std::string BagMessage(int connection,
                       std::uint32_t seconds,
                       std::uint32_t nanoseconds,
                       const std::string& data) {
  return BagRecord(
      {{"conn", Bytes(connection)}, {"op", "\x02"}, {"time", Bytes(seconds) + Bytes(nanoseconds)}},
      data);
}

std::string BagChunk(const std::string& compression, const std::string& records) {
  return BagRecord({{"compression", compression},
                    {"op", "\x05"},
                    {"size", Bytes(static_cast<std::uint32_t>(records.size()))}},
                   Compressed(compression, records));
}

std::string BagHead() {
  return "#ROSBAG V2.0\n" + BagRecord({{"index_pos", Bytes<std::uint64_t>(0)}, {"op", "\x03"}},
                                      std::string(4000, ' '));
}

// A dive of half an hour: three images in each second, odometry and thrust at 50 Hz.
void WriteLargeBag(const fs::path& path, const std::string& compression) {
  std::ofstream file(path, std::ios::binary);
  std::string records = BagConnection(0, "/odom", "nav_msgs/Odometry", kOdometry) +
                        BagConnection(1, "/thrust", "geometry_msgs/WrenchStamped", kWrench) +
                        BagConnection(2, "/camera", "sensor_msgs/Image", kImage);
  file << BagHead();
  std::string pixels(640 * 480, '\0');
  std::uint32_t noise = 1;
  for (char& pixel : pixels)
    pixel = static_cast<char>((noise = noise * 1664525 + 1013904223) >> 24);
  for (std::uint32_t second = 0; static_cast<std::uint64_t>(file.tellp()) < kLargeBag; ++second) {
    const std::uint32_t time = 1500000000 + second;
    for (int k = 0; k < 50; ++k) {
      const auto part = static_cast<std::uint32_t>(k) * 20'000'000;
      const int row = static_cast<int>(second) * 50 + k;
      const std::string header = Ros1Header(time, part);
      records += BagMessage(0, time, part, header + Counted("base") + Numbers(85, row));
      records += BagMessage(1, time, part, header + Numbers(6, row));
      if (k % 17 != 0) continue;
      records += BagMessage(2,
                            time,
                            part,
                            header + Bytes(480) + Bytes(640) + Counted("mono8") + '\0' +
                                Bytes(640) + Counted(pixels));
    }
    file << BagChunk(compression, records);
    records.clear();
  }
}

// --- What is measured

// Reads all that a listed recording holds. Gives the number of samples.
std::uint64_t ReadAll(const Recording& recording) {
  std::vector<Selection> selections;
  for (const Channel& channel : recording.contents().channels) {
    Selection& selection = selections.emplace_back(Selection{channel.name, {}});
    for (const Field& field : channel.fields) selection.fields.push_back(field.name);
  }
  std::uint64_t count = 0;
  recording.Read(selections, [&](std::size_t, double, std::span<const double>) { ++count; });
  if (count == 0 || !recording.contents().IsComplete()) {
    throw std::runtime_error("a recording is not read as it should be");
  }
  return count;
}

std::uint64_t ListAndRead(const fs::path& path) { return ReadAll(*OpenRecording(path)); }

void ReadPlainly(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> block(kChunkSize);
  while (file.read(block.data(), static_cast<std::streamsize>(block.size()))) continue;
}

bool MeasureFormat(const std::string& name, const fs::path& path, bool is_compressed = false) {
  const double megabytes = static_cast<double>(fs::file_size(path)) / 1e6;
  ReadPlainly(path);  // into the system's memory
  const double plain = CpuSecondsOf([&] { ReadPlainly(path); });
  std::uint64_t count = 0;
  const double ours = CpuSecondsOf([&] { count = ListAndRead(path); });
  fs::remove(path);
  const double speed = megabytes / ours;
  return Report(fmt::format("{}: {:.0f} MB, {:.2f} million samples/s, {:.0f} x a read",
                            name,
                            megabytes,
                            static_cast<double>(count) / ours / 1e6,
                            ours / plain),
                speed,
                "MB/s",
                is_compressed || speed >= kLeastSpeed,
                is_compressed ? "" : fmt::format("at least {:.0f}", kLeastSpeed));
}

ChildResult RunPeer(const std::string& program, const std::vector<std::string>& arguments) {
  ChildResult run = RunChild({.program = FATHOM_PEERS "/" + program, .arguments = arguments});
  if (run.exit_code != 0) {
    fmt::print("{} does not run here, not measured: {}\n", program, run.err);
  }
  return run;
}

bool MeasureFormats(const fs::path& folder) {
  const std::string bag_records =
      BagConnection(0, "/odom", "nav_msgs/Odometry", kOdometry) + Repeated(1400, [](int k) {
        return BagMessage(0, 1500000000 + k / 100, k % 100 * 10000000U, Ros1Odometry(k));
      });
  bool holds = MeasureFormat("csv", WriteCsv(folder / "a.csv"));
  holds &= MeasureFormat("dataflash", WriteDataflash(folder / "a.bin"));
  holds &= MeasureFormat("ulog", WriteUlog(folder / "a.ulg"));
  holds &= MeasureFormat("tlog", WriteTlog(folder / "a.tlog"));
  holds &= MeasureFormat("pocolog", WritePocolog(folder / "a.0.log"));
  for (const char* compression : {"none", "lz4"}) {
    holds &=
        MeasureFormat(fmt::format("bag, {}", compression),
                      WriteTiled(folder / "a.bag", BagHead(), BagChunk(compression, bag_records)),
                      compression != std::string("none"));
  }
  for (const char* compression : {"", "lz4", "zstd"}) {
    const std::string name = *compression == '\0' ? "none" : compression;
    holds &=
        MeasureFormat("mcap, " + name, WriteMcap(folder / "a.mcap", compression), name != "none");
  }
  holds &= MeasureFormat("rosbag2", WriteDatabase(folder / "a.db3"));
  if (RunPeer("write_mat.py", {folder.string()}).exit_code == 0) {
    holds &= MeasureFormat(".mat of version 5", folder / "plain_5.mat");
    holds &= MeasureFormat(".mat of version 5, compressed", folder / "packed_5.mat", true);
    holds &= MeasureFormat(".mat of version 7.3", folder / "plain_73.mat");
    holds &= MeasureFormat(".mat of version 7.3, compressed", folder / "packed_73.mat", true);
  }
  return holds;
}

// A file as a program in Python reads it once, message by message, and prints how many there are.
// We read it once in the same way; the list of its channels takes another pass before.
bool MeasurePeer(const std::string& what,
                 const fs::path& path,
                 const std::string& program,
                 double least) {
  const ChildResult peer = RunPeer(program, {path.string()});
  if (peer.exit_code != 0) return true;
  const auto recording = OpenRecording(path);
  std::uint64_t count = 0;
  const double listed = CpuSecondsOf([&] { OpenRecording(path); });
  const double read = CpuSecondsOf([&] { count = ReadAll(*recording); });
  fmt::print("{}: {} samples listed in {:.3f} s, read in {:.3f} s; {} messages in {:.2f} s\n",
             what,
             count,
             listed,
             read,
             peer.out.substr(0, peer.out.find('\n')),
             peer.cpu_seconds);
  bool holds = true;
  for (const auto& [how, seconds] : {std::pair("listed and read", listed + read), {"read", read}}) {
    const double times = peer.cpu_seconds / seconds;
    holds &= Report(fmt::format("  times as fast as {}, {}", program, how),
                    times,
                    "",
                    times >= least,
                    fmt::format("at least {:.0f}", least));
  }
  return holds;
}

bool MeasurePeers(const fs::path& folder) {
  bool holds = true;
  for (const char* compression : {"none", "lz4"}) {
    const fs::path bag = folder / fmt::format("{}.bag", compression);
    if (RunPeer("write_bag.py", {bag.string(), compression, "50000"}).exit_code != 0) break;
    holds &= MeasurePeer(
        fmt::format("bag of rosbag, {}", compression), bag, "read_bag.py", kLeastOverPython);
    fs::remove(bag);
  }
  const fs::path log = WriteDataflash(folder / "a.bin");
  holds &= MeasurePeer("dataflash", log, "read_dataflash.py", kLeastOverPython);
  fs::remove(log);
  return holds;
}

// Tables of one number of cells take one time, however many columns they have.
bool MeasureWideTables(const fs::path& folder) {
  constexpr int kCells = 2'000'000;
  constexpr double kMostRatio = 3.0;
  std::vector<double> seconds;
  for (const int columns : {100, 100'000}) {
    const fs::path path = folder / "wide.csv";
    std::ofstream file(path, std::ios::binary);
    for (int i = 0; i < columns; ++i) file << (i == 0 ? "t" : fmt::format(",c{}", i));
    for (int row = 0; row < kCells / columns; ++row) {
      file << '\n' << 0.1 * row;
      for (int i = 1; i < columns; ++i) file << ',' << (i + row) % 7;
    }
    file << '\n';
    file.close();
    seconds.push_back(CpuSecondsOf([&] { ListAndRead(path); }));
  }
  const double ratio = seconds[1] / seconds[0];
  return Report(fmt::format("Time of a csv of 100000 columns ({:.2f} s) to one of 100 ({:.2f} s)",
                            seconds[1],
                            seconds[0]),
                ratio,
                "",
                ratio <= kMostRatio,
                fmt::format("at most {:.0f}", kMostRatio));
}

bool MeasureMemory(const fs::path& folder) {
  bool holds = true;
  const fs::path bag = folder / "large.bag", map = folder / "map.yaml";
  std::ofstream(map) << "command: {channel: /thrust, frame: FLU, tau_surge: {field: "
                        "wrench.force.x, unit: N}}\n"
                        "velocity: {channel: /odom, frame: FLU, u: {field: twist.twist.linear.x, "
                        "unit: m/s}}\n"
                        "dof: surge\n";
  for (const char* compression : {"none", "lz4"}) {
    WriteLargeBag(bag, compression);
    const std::string from = "--from=" + bag.string();
    const std::vector<std::pair<std::string, std::vector<std::string>>> runs = {
        {"listed", {from, "--list"}},
        {"imported", {from, "--map=" + map.string(), "--out=" + (folder / "log").string()}}};
    for (const auto& run : runs) {
      const ChildResult result = RunChild({.program = FATHOM_IMPORT, .arguments = run.second});
      if (result.exit_code != 0) {
        throw std::runtime_error("fathom_import: " + result.err);
      }
      const double peak = result.peak_memory / 1e6;
      holds &= Report(fmt::format("Peak memory, 2 GB of bag ({}) {} in {:.1f} s",
                                  compression,
                                  run.first,
                                  result.seconds),
                      peak,
                      "MB",
                      peak <= kMostMemory,
                      fmt::format("at most {:.0f}", kMostMemory));
    }
    fs::remove_all(folder / "log");
    fs::remove(bag);
  }
  return holds;
}

}  // namespace
}  // namespace fathom

int main() {
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("import_bench_{}", getpid());
  std::filesystem::create_directories(folder);
  int exit_code = 2;
  try {
    const bool memory = fathom::MeasureMemory(folder);
    const bool wide = fathom::MeasureWideTables(folder);
    const bool formats = fathom::MeasureFormats(folder);
    const bool peers = fathom::MeasurePeers(folder);
    exit_code = memory && wide && formats && peers ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "import_bench: {}\n", error.what());
  }
  std::filesystem::remove_all(folder);  // gigabytes
  return exit_code;
}
