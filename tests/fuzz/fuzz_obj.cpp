#include <string_view>

#include "fuzz/fuzz_checks.h"
#include "mesh/obj_reader.h"

namespace karcher {
namespace {

void open(std::string_view text, bool repair) {
  try {
    ImportOptions options;
    options.repair = repair;
    const ImportedMesh imported = importObj(text, options);
    expectSoundMesh(imported);
    const ObjContents contents = readObj(text, {repair, {}});
    expect(imported.numbering.inputFaceCount() == contents.soup.triangles.count() &&
               imported.numbering.engineVertex.count() == contents.soup.positions.count(),
           "the file has other vertices or triangles than its mesh");
    if (!repair) return;
    for (int t = 0; t < contents.soup.triangles.count(); ++t) {
      const Vec3 bary(0.2, 0.3, 0.5);
      try {
        expectOnSurface(imported.mesh, toEngine(imported.numbering, imported.mesh, t, bary));
      } catch (const Error& error) {
        expect(error.code() == ErrorCode::kBadIndex,
               error.what());  // the triangle is not part of the mesh
      }
    }
  } catch (const Error& error) {
    expectSentence(error);
  }
}

}  // namespace

void fuzzObj(Bytes bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  open(text, true);
  open(text, false);
}

}  // namespace karcher
