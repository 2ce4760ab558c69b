// Writes the seeds of the targets: FOLDER/obj/0, ..., FOLDER/curve/47.
//   fuzz_corpus FOLDER
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "fuzz/fuzz_seeds.h"

namespace karcher {
namespace {

void write(const std::filesystem::path& folder, const Array<Seed>& seeds) {
  std::filesystem::create_directories(folder);
  for (int i = 0; i < seeds.count(); ++i) {
    std::ofstream file(folder / std::to_string(i), std::ios::binary);
    for (const uint8_t byte : seeds[i]) file.put(static_cast<char>(byte));
    if (!file.flush()) throw std::runtime_error("cannot write to " + folder.string());
  }
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  using namespace karcher;
  try {
    if (argc != 2) throw std::runtime_error("Usage: fuzz_corpus FOLDER");
    const std::filesystem::path folder = argv[1];
    write(folder / "obj", objSeeds());
    write(folder / "repairs", repairsSeeds());
    write(folder / "curve", curveSeeds());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
