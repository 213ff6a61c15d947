#include "common/runner/saved_state.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "common/particles/pack.hpp"
#include "common/runner/atomic_file.hpp"
#include "common/runner/machine.hpp"
#include "common/simulation/errors.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr std::string_view mark = "Clapotis state ";
constexpr int format_number = 1;
constexpr std::size_t sum_size = sizeof(std::uint64_t);

std::string header_of(const SavedState& saved) {
  Json parameters = Json::array();
  for (const auto& [name, given] : saved.parameters)
    parameters.push_back({{"name", name},
                          {"value", given.text},
                          {"unit", given.unit},
                          {"origin", static_cast<int>(given.origin)}});
  return Json{{"version", version()},
              {"build", program_fingerprint()},
              {"vector_width", static_cast<int>(pack_width)},
              {"stage", saved.stage},
              {"scene", saved.scene},
              {"integrator", saved.integrator},
              {"time", saved.time},
              {"steps", saved.steps},
              {"parameters", parameters}}
      .dump(1);
}

/// The parts of the file as it is written.
struct PartsOfState {
  std::string_view header, state;
};

/// One state file that is being read: its sentences name it.
struct StateReader {
  const fs::path& file;

  template <class... Args>
  [[noreturn]] void refuse(std::string_view sentence, const Args&... args) const {
    throw FileError(say(sentence, fmt::arg("file", file.string()), args...));
  }

  [[nodiscard]] std::string text() const {
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    std::error_code ignored;
    if (!in || fs::is_directory(file, ignored)) refuse_file(words().cannot_read, file, in ? EISDIR : errno);
    std::ostringstream all;
    all << in.rdbuf();
    if (in.bad()) refuse_file(words().cannot_read, file, errno == 0 ? EIO : errno);
    return std::move(all).str();
  }

  /// The numbers of the first line.
  [[nodiscard]] std::array<std::size_t, 3> sizes(std::string_view line) const {
    if (!line.starts_with(mark)) refuse(words().state_no_state);
    std::array<std::size_t, 3> numbers{};
    const char* at = line.data() + mark.size();
    for (auto& number : numbers) {
      const auto [end, error] = std::from_chars(at, line.data() + line.size(), number);
      if (error != std::errc()) refuse(words().state_damaged);
      at = end + 1;
    }
    return numbers;
  }

  [[nodiscard]] PartsOfState parts(std::string_view all) const {
    const auto newline = std::min(all.find('\n'), all.size());
    const auto [format, header_size, state_size] = sizes(all.substr(0, newline));
    if (format != format_number)
      refuse(words().state_other_format, fmt::arg("format", format), fmt::arg("own", format_number));
    const auto start = std::min(newline + 1, all.size());
    const auto rest = all.size() - start;
    if (rest < sum_size || rest - sum_size < header_size || rest - sum_size - header_size < state_size)
      refuse(words().state_cut_short, fmt::arg("bytes", all.size()),
             fmt::arg("whole", start + header_size + state_size + sum_size));
    const auto summed = all.substr(0, all.size() - sum_size);
    std::uint64_t sum = 0;
    std::memcpy(&sum, all.data() + summed.size(), sum_size);
    if (rest != header_size + state_size + sum_size || sum != fingerprint(summed))
      refuse(words().state_damaged);
    return {all.substr(start, header_size), all.substr(start + header_size, state_size)};
  }

  /// Who may go on with it: the same program.
  void check_program(const Json& header) const {
    const auto its_version = header.at("version").get<std::string>();
    const auto its_width = header.at("vector_width").get<int>();
    if (its_version != version())
      refuse(words().state_other_version, fmt::arg("other", its_version), fmt::arg("own", version()));
    if (its_width != pack_width)
      refuse(words().state_other_width, fmt::arg("other", its_width),
             fmt::arg("own", static_cast<int>(pack_width)));
    if (header.at("build").get<std::string>() != program_fingerprint()) refuse(words().state_other_build);
  }
};

/// A value that is given besides a state: equal to that of the run, or a change that it allows.
void apply_change(Simulation& simulation, const fs::path& state, const std::string& name,
                  const Override& given) {
  const auto* known = simulation.parameters().find(name);
  from_place(given.place, [&] {
    if (known != nullptr && !known->derived) {
      const double value = known->parse(given.text);
      if (value == known->value || (std::isnan(value) && std::isnan(known->value))) return;
      if (known->change == Change::restart)
        throw BadInput(say(words().state_contradiction, fmt::arg("name", name), fmt::arg("value", given.text),
                           fmt::arg("file", state.string()), fmt::arg("other", known->text())));
    }
    simulation.set(name, given.text, given.origin);
  });
}

}  // namespace

SavedState copy_state(const Stage& stage, Simulation& simulation) {
  StateBytes state;
  simulation.pass_state(state);
  return {.stage = stage.name,
          .scene = simulation.scene().name,
          .integrator = simulation.integrator(),
          .parameters = simulation.built_from(),
          .time = simulation.time(),
          .steps = simulation.steps(),
          .bytes = state.bytes()};
}

void write_state(const fs::path& file, const SavedState& saved) {
  const auto head = header_of(saved);
  auto all = fmt::format("{}{} {} {}\n", mark, format_number, head.size(), saved.bytes.size());
  all += head;
  all += saved.bytes;
  const std::uint64_t sum = fingerprint(all);
  all.append(reinterpret_cast<const char*>(&sum), sum_size);
  write_file(file, all);
}

SavedState read_state(const fs::path& file, const Stage& stage) {
  const StateReader reader{file};
  const auto all = reader.text();
  const auto [head, bytes] = reader.parts(all);
  SavedState saved;
  try {
    const auto json = Json::parse(head);
    saved.stage = json.at("stage").get<std::string>();
    if (saved.stage != stage.name)
      throw BadInput(say(words().config_other_stage, fmt::arg("file", file.string()),
                         fmt::arg("other", saved.stage), fmt::arg("stage", stage.name)));
    reader.check_program(json);
    saved.scene = json.at("scene").get<std::string>();
    saved.integrator = json.at("integrator").get<std::string>();
    saved.time = json.at("time").get<double>();
    saved.steps = json.at("steps").get<long>();
    for (const auto& given : json.at("parameters"))
      saved.parameters[given.at("name").get<std::string>()] = {
          given.at("value").get<std::string>(),
          static_cast<Origin>(given.at("origin").get<int>()),
          {},
          given.at("unit").get<std::string>()};
  } catch (const Json::exception&) {
    reader.refuse(words().state_damaged);
  }
  saved.bytes = bytes;
  saved.file = file;
  return saved;
}

std::unique_ptr<Simulation> resume_simulation(const Stage& stage, const SavedState& saved, int threads) {
  auto simulation =
      std::make_unique<Simulation>(stage.scene(saved.scene), saved.parameters, saved.integrator, threads);
  StateBytes state(saved.bytes);
  try {
    simulation->pass_state(state);
  } catch (const ForeignState&) {
    StateReader{saved.file}.refuse(words().state_damaged);
  }
  return simulation;
}

std::unique_ptr<Simulation> start_simulation(const Stage& stage, const Options& options) {
  if (!options.resume)
    return std::make_unique<Simulation>(stage.scene(options.scene.value), options.parameters,
                                        options.integrator.value, options.threads.value);
  auto simulation = resume_simulation(stage, *options.resume, options.threads.value);
  if (options.integrator.value != simulation->integrator())
    simulation->use_integrator(options.integrator.value);
  for (const auto& [name, given] : options.parameters)
    apply_change(*simulation, options.resume->file, name, given);
  return simulation;
}

}  // namespace clapotis
