// A client of a daemon in C++: 10,000 times attached and let go, moved, copied and shared by threads. `attach MAP [COUNT]`.
#include <mapd.hpp>

#include <malloc.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr double patience = 60.0;
/// Times before memory is looked at: what is made once is made then.
constexpr int warm = 100;
/// What the allocator may keep for itself [bytes].
constexpr std::size_t slack = 16384;

std::size_t files() {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& one : std::filesystem::directory_iterator("/proc/self/fd")) ++count;
  return count;
}

/// What is allocated [bytes]. Under sanitizers it is always 0, and they look for leaks themselves.
std::size_t heap() { return mallinfo2().uordblks; }

/// Mappings of the domain's shared memory.
std::size_t mappings() {
  const std::string prefix = std::getenv("MAPD_PREFIX");
  std::ifstream file("/proc/self/maps");
  std::size_t count = 0;
  for (std::string line; std::getline(file, line);) count += line.find(prefix) != std::string::npos ? 1 : 0;
  return count;
}

bool answers(const mapd::Snapshot& map) {
  const auto hit = map.nearest_lane({50.0, -1.75});
  return hit && hit->position.distance == 0.0;
}

bool attach(const std::string& name) {
  auto client = mapd::Client::connect(name, patience);
  mapd::Snapshot map = client.snapshot();
  const mapd::Snapshot copy = map;
  auto events = client.events();
  const mapd::Client moved = std::move(client);
  const mapd::Snapshot last = std::move(map);
  return answers(copy) && answers(last) && !events.next(0.0);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) return 1;
  const std::string name = argv[1];
  const int count = argc > 2 ? std::atoi(argv[2]) : 10000;
  bool good = true;
  for (int i = 0; i < warm && good; ++i) good = attach(name);
  const std::size_t before = files(), used = heap();
  for (int i = 0; i < count && good; ++i) good = attach(name);
  const auto kept = static_cast<long long>(heap()) - static_cast<long long>(used);
  std::printf("attach: %lld bytes more after %d times\n", kept, count);
  good = good && files() == before && mappings() == 0 && kept <= static_cast<long long>(slack);

  const auto client = mapd::Client::connect(name, patience);
  const auto map = client.snapshot();
  client.set_populate(true);
  good = good && client.generation() >= 1 && !client.pending();
  good = good && answers(client.require(client.generation(), patience));
  const auto waiting = mapd::propose(name, "first", R"({"id":"rain","kind":"wet","lanes":[{"road":"1"}]})", patience);
  good = good && !waiting.is_accepted && waiting.needed == 2;
  const auto refused = mapd::try_propose(name, "nobody", R"({"id":"rain","kind":"wet","lanes":[{"road":"1"}]})", patience);
  good = good && !refused && refused.error().code == MAPD_CODE_REFUSED;
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&] {
      for (int k = 0; k < 200; ++k) wrong += answers(map) && answers(client.refresh()) ? 0 : 1;
    });
  }
  for (auto& thread : threads) thread.join();
  good = good && wrong == 0;
  std::printf("attach: %d times, %s\n", count, good ? "nothing left" : "failed");
  return good ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
