#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "tests/common/programs.hpp"

// What --vtk leaves, read back by an XML reader of a page and a base64 of three lines.

using namespace clapotis::testing;
using Catch::Matchers::ContainsSubstring;
namespace fs = std::filesystem;

namespace {

/// An element of an XML file.
struct Element {
  std::string name, text;
  std::map<std::string, std::string> attributes;
  std::vector<Element> inner;

  [[nodiscard]] const Element& find(const std::string& wanted) const {
    for (const auto& element : inner)
      if (element.name == wanted) return element;
    throw std::runtime_error("no element " + wanted + " in " + name);
  }
  [[nodiscard]] const Element& array(const std::string& wanted) const {
    for (const auto& element : inner)
      if (element.attributes.contains("Name") && element.attributes.at("Name") == wanted) return element;
    throw std::runtime_error("no array " + wanted + " in " + name);
  }
};

/// Reads one element and what is in it; throws when tags do not match, or a sign stands where it may not.
class Xml {
 public:
  explicit Xml(std::string text) : text_(std::move(text)) {
    const std::string declaration = "<?xml version=\"1.0\"?>\n";
    if (!text_.starts_with(declaration)) throw std::runtime_error("no declaration");
    at_ = declaration.size();
  }
  Element root() {
    auto element = read_element();
    if (text_.substr(at_) != "\n") throw std::runtime_error("something behind the root");
    return element;
  }

 private:
  Element read_element() {
    expect('<');
    Element element;
    element.name = word(" />");
    while (text_.at(at_) == ' ') {
      ++at_;
      const auto key = word("=");
      expect('=');
      expect('"');
      element.attributes[key] = word("\"");
      expect('"');
    }
    if (text_.at(at_) == '/') {
      at_ += 2;
      return element;
    }
    expect('>');
    for (;;) {
      element.text += word("<");
      if (text_.at(at_ + 1) == '/') break;
      element.inner.push_back(read_element());
    }
    const auto end = "</" + element.name + ">";
    if (text_.compare(at_, end.size(), end) != 0) throw std::runtime_error("no end of " + element.name);
    at_ += end.size();
    return element;
  }
  std::string word(const std::string& ends) {
    const auto end = text_.find_first_of(ends, at_);
    if (end == std::string::npos) throw std::runtime_error("the file ends inside an element");
    const auto found = text_.substr(at_, end - at_);
    for (const char c : found)
      if (static_cast<unsigned char>(c) >= 127 || (c < ' ' && c != '\n'))
        throw std::runtime_error("not a sign");
    at_ = end;
    return found;
  }
  void expect(char c) {
    if (text_.at(at_++) != c) throw std::runtime_error("expected " + std::string(1, c));
  }
  std::string text_;
  std::size_t at_ = 0;
};

std::string from_base64(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char c : text) {
    const auto six = letters.find(c);
    if (six == std::string::npos) continue;  // line ends, and = at the end
    bits = (bits << 6U | static_cast<unsigned>(six)) & 0xFFFFFFU;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xFFU);
  }
  return bytes;
}

/// The numbers of an array, whose size stands before them.
template <class T>
std::vector<T> numbers(const Element& array) {
  const auto bytes = from_base64(array.text);
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data(), sizeof size);
  REQUIRE(bytes.size() == sizeof size + size);
  std::vector<T> all(size / sizeof(T));
  std::memcpy(all.data(), bytes.data() + sizeof size, size);
  return all;
}

std::vector<std::vector<std::string>> rows(const fs::path& file) {
  std::istringstream lines(read(file));
  std::vector<std::vector<std::string>> all;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    all.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) all.back().push_back(cell);
  }
  return all;
}

}  // namespace

TEST_CASE("the grids of --vtk hold the bits of final.csv, walls included, with units and times", "[vtk]") {
  const Scratch scratch;
  const auto ended = run(
      scratch, stage4,
      {"dam_break", "--headless", "--set", "spacing=0.1", "--until", "0.2", "--vtk", "0.05", "--out", "r"});
  require_done(ended);
  const auto list = Xml(read(scratch / "r" / "vtk.pvd")).root();
  CHECK(list.attributes.at("type") == "Collection");
  const auto& sets = list.find("Collection").inner;
  REQUIRE(sets.size() == 5);  // 0, 0.05, ... 0.2
  for (std::size_t k = 0; k < sets.size(); ++k) {
    // the first step at or after each multiple: less than a step of 0.01 s late
    const double time = std::stod(sets[k].attributes.at("timestep"));
    CHECK(time == Approx(0.05 * static_cast<double>(k)).margin(0.01));
    const auto grid = Xml(read(scratch / "r" / sets[k].attributes.at("file"))).root();
    CHECK(std::stod(grid.find("UnstructuredGrid").find("FieldData").array("TimeValue").text) == time);
  }
  CHECK(sets.back().attributes.at("timestep") == "0.2");

  const auto table = rows(scratch / "r" / "final.csv");
  const std::size_t count = table.size() - 1;
  const auto grid = Xml(read(scratch / "r" / "vtk" / "0004.vtu")).root();
  CHECK(grid.attributes.at("type") == "UnstructuredGrid");
  const auto& piece = grid.find("UnstructuredGrid").find("Piece");
  CHECK(piece.attributes.at("NumberOfPoints") == std::to_string(count));
  CHECK(piece.attributes.at("NumberOfCells") == std::to_string(count));
  const auto& data = piece.find("PointData");
  const auto ids = numbers<std::int64_t>(data.array("id"));
  const auto kinds = numbers<std::uint8_t>(data.array("kind"));
  const auto points = numbers<double>(piece.find("Points").array("Points"));
  const auto v = numbers<double>(data.array("velocity")), a = numbers<double>(data.array("acceleration"));
  const auto density = numbers<double>(data.array("density")),
             pressure = numbers<double>(data.array("pressure"));
  REQUIRE(ids.size() == count);
  REQUIRE(points.size() == 3 * count);
  REQUIRE(v.size() == 3 * count);
  REQUIRE(density.size() == count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& row = table[i + 1];
    REQUIRE(std::to_string(ids[i]) == row[0]);
    REQUIRE((kinds[i] == 1) == (row[1] == "wall"));
    const double values[] = {points[3 * i], points[3 * i + 1], v[3 * i],   v[3 * i + 1],
                             a[3 * i],      a[3 * i + 1],      density[i], pressure[i]};
    for (std::size_t k = 0; k < std::size(values); ++k) REQUIRE(values[k] == std::stod(row[k + 2]));
  }
  CHECK(data.array("pressure").find("InformationKey").text == "kg/(m s^2)");
  CHECK(data.array("velocity").find("InformationKey").text == "m/s");
  const auto& cells = piece.find("Cells");
  CHECK(numbers<std::int64_t>(cells.array("offsets")).back() == static_cast<std::int64_t>(count));
  CHECK(numbers<std::uint8_t>(cells.array("types")) == std::vector<std::uint8_t>(count, 1));
  const auto units = nlohmann::json::parse(read(scratch / "r" / "run.json"))["units"]["vtk"];
  CHECK(units["acceleration"] == "m/s^2");
  CHECK(units["density"] == "kg/m^3");
}

TEST_CASE("where particles come and go their ids in a grid are those of final.csv", "[vtk]") {
  const Scratch scratch;
  require_done(run(
      scratch, stage5,
      {"channel", "--headless", "--set", "spacing=1e-3", "--until", "0.2", "--vtk", "0.2", "--out", "r"}));
  const auto table = rows(scratch / "r" / "final.csv");
  const auto grid = Xml(read(scratch / "r" / "vtk" / "0001.vtu")).root();
  const auto& piece = grid.find("UnstructuredGrid").find("Piece");
  const auto ids = numbers<std::int64_t>(piece.find("PointData").array("id"));
  const auto points = numbers<double>(piece.find("Points").array("Points"));
  REQUIRE(ids.size() == table.size() - 1);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    REQUIRE(std::to_string(ids[i]) == table[i + 1][0]);
    REQUIRE(points[3 * i] == std::stod(table[i + 1][2]));
  }
  CHECK(static_cast<std::size_t>(ids.back()) > ids.size());  // some have left
}

TEST_CASE("a run that is replaced takes its grids with it, and a replay has the same ones", "[vtk]") {
  const Scratch scratch;
  require_done(
      run(scratch, stage2,
          {"cloud", "--headless", "--steps", "5", "--set", "particles=7", "--vtk", "1e-9", "--out", "r"}));
  REQUIRE(fs::exists(scratch / "r" / "vtk" / "0005.vtu"));
  require_done(run(scratch, stage2, {"--headless", "--config", "r/run.json", "--out", "again"}));
  CHECK(read(scratch / "r" / "vtk" / "0005.vtu") == read(scratch / "again" / "vtk" / "0005.vtu"));
  require_done(run(scratch, stage2, {"cloud", "--headless", "--steps", "2", "--out", "r", "--force"}));
  CHECK_FALSE(fs::exists(scratch / "r" / "vtk"));
  CHECK_FALSE(fs::exists(scratch / "r" / "vtk.pvd"));
}
