#include "report/studies/peers.hpp"

#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "report/studies/measured.hpp"

namespace clapotis::studies {
namespace {

/// The peer at work: its answers come one line after another, the coarsest first.
class PeerProcess {
 public:
  explicit PeerProcess(const std::vector<int>& resolutions)
      : pipe_(popen(command(resolutions).c_str(), "r")) {}
  ~PeerProcess() {
    if (pipe_ != nullptr) pclose(pipe_);
  }
  PeerProcess(const PeerProcess&) = delete;
  PeerProcess& operator=(const PeerProcess&) = delete;

  /// Reads on until there is an answer for this resolution.
  std::optional<PeerDrop> answer(int resolution) {
    while (!answers_.contains(resolution) && read_one()) heed_interrupt();
    heed_interrupt();
    const auto found = answers_.find(resolution);
    return found == answers_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  static std::string command(const std::vector<int>& resolutions) {
    std::string text = "exec '" PEERS "/pysph_elliptical_drop.py' --nx";
    for (const int each : resolutions) text += ' ' + std::to_string(each);
    return text + " 2> /dev/null";
  }

  bool read_one() {
    std::string line;
    for (int byte = 0; pipe_ != nullptr && (byte = std::fgetc(pipe_)) != EOF && byte != '\n';)
      line += static_cast<char>(byte);
    const auto json = nlohmann::json::parse(line, nullptr, false);
    if (!json.is_object()) return false;
    answers_[json.at("nx").get<int>()] = {.b_error = json.at("b_error").get<double>(),
                                          .b_largest = json.at("b_largest").get<double>(),
                                          .energy_error = json.at("energy_error").get<double>(),
                                          .energy_largest = json.at("energy_largest").get<double>(),
                                          .seconds = json.at("cpu_seconds").get<double>(),
                                          .steps = json.at("steps").get<long>(),
                                          .particles = json.at("particles").get<long>()};
    return true;
  }

  std::FILE* pipe_;
  std::map<int, PeerDrop> answers_;
};

}  // namespace

std::function<std::optional<PeerDrop>(int)> run_pysph_drops(std::vector<int> resolutions) {
  const auto process = std::make_shared<std::unique_ptr<PeerProcess>>();
  return [=](int resolution) {
    if (!*process) *process = std::make_unique<PeerProcess>(resolutions);
    return (*process)->answer(resolution);
  };
}

}  // namespace clapotis::studies
