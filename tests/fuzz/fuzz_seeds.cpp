#include "fuzz/fuzz_seeds.h"

#include <array>
#include <string_view>

#include "generators/random.h"

namespace karcher {
namespace {

using Corner = std::array<int, 3>;

Seed asSeed(std::string_view text) { return {text.begin(), text.end()}; }

void append(Seed& seed, int byte) { seed.push_back(static_cast<uint8_t>(byte)); }

/// A case in the form of `fuzzRepairs`: with all repairs, on a lattice of 16 places along each
/// axis.
Seed ofMesh(std::initializer_list<Corner> places, std::initializer_list<Corner> triangles,
            bool isExploded = false) {
  Seed seed;
  Seed corners;
  for (const int option : {0, 0, 14, 0, 0}) append(seed, option);
  if (isExploded) {
    append(seed, static_cast<int>(3 * triangles.size()) - 3);
    for (const Corner& triangle : triangles) {
      for (const int v : triangle) {
        for (const int coordinate : places.begin()[v]) append(seed, coordinate);
        append(seed, 0);
        append(corners, static_cast<int>(corners.size()));
      }
    }
  } else {
    append(seed, static_cast<int>(places.size()) - 3);
    for (const Corner& place : places) {
      for (const int coordinate : place) append(seed, coordinate);
      append(seed, 0);
    }
    for (const Corner& triangle : triangles) {
      for (const int v : triangle) append(corners, v);
    }
  }
  seed.insert(seed.end(), corners.begin(), corners.end());
  return seed;
}

}  // namespace

Array<Seed> objSeeds() {
  return {
      asSeed("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"),
      asSeed("# a square\nv 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0 1.0\r\nf 1 2 3 4 # all\r\n"),
      asSeed("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nf -5 -4 -3 -2 -1\n"),
      asSeed("o one\ng two\nusemtl red\nvt 0 0\nvn 0 0 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
             "s off\nf 1/1/1 2/1/1 3//1\nl 1 2\np 1\n"),
      asSeed("v nan inf -inf\nv 1e-3 -2.5E+2 .5\nv 1 0 0\nv 0 1 0\nf 2 3 4\nf 2 2 3\n"),
      asSeed("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 1 1 0\nf 1 \\\n2 4\nf 2 3 4\nf 1 3 2\n"),
      asSeed("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 2 0 0\n"
             "f 1 2 3 3 4\nf 5 7 6\nf 5 7 6\n"),
      asSeed("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"),
      asSeed("v 0 0 x\nf 1 2 3\n"),
  };
}

Array<Seed> repairsSeeds() {
  const auto tetrahedron = {Corner{0, 2, 1}, Corner{0, 1, 3}, Corner{0, 3, 2}, Corner{1, 2, 3}};
  const auto corners = {Corner{0, 0, 0}, Corner{8, 0, 0}, Corner{0, 8, 0}, Corner{0, 0, 8}};
  return {
      ofMesh(corners, tetrahedron),
      ofMesh(corners, tetrahedron, true),
      // One face is reversed, one is repeated, one has a repeated corner.
      ofMesh(corners, {{0, 1, 2}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {1, 2, 3}, {1, 1, 3}}),
      // A fin.
      ofMesh({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}, {4, 4, 12}},
             {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {1, 2, 4}}),
      // A bow tie.
      ofMesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {8, 0, 0}, {8, 4, 0}}, {{0, 1, 2}, {1, 3, 4}}),
      // A degenerate triangle.
      ofMesh({{0, 0, 0}, {8, 0, 0}, {4, 0, 0}, {4, 8, 0}, {4, 0, 8}},
             {{0, 1, 3}, {0, 2, 1}, {0, 4, 2}, {2, 4, 1}}),
      // A strip that closes with half a turn, and one with a whole one.
      ofMesh({{0, 0, 0}, {8, 0, 2}, {8, 8, 6}, {0, 0, 4}, {8, 0, 8}, {8, 8, 0}},
             {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 3, 5}, {3, 0, 5}}),
      ofMesh({{0, 0, 0}, {8, 0, 0}, {4, 8, 0}, {0, 0, 4}, {8, 0, 4}, {4, 8, 4}},
             {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 0, 5}, {0, 3, 5}}),
      // The two sides of a sheet.
      ofMesh({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}, {4, 4, 0}},
             {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 4}, {2, 1, 4}}, true),
  };
}

Array<Seed> curveSeeds() {
  // Any random bytes serve as points, kinds and edits: only the meshes matter.
  Random random(1);
  Array<Seed> seeds;
  for (int i = 0; i < 48; ++i) {
    Seed seed;
    append(seed, i % 12);
    const int length = 40 + random.index(120);
    while (seed.count() < length) append(seed, random.index(256));
    seeds.push_back(seed);
  }
  return seeds;
}

}  // namespace karcher
