#include "io/load_mesh.h"

#include <cmath>
#include <cstdint>
#include <new>

#include "base/error.h"
#include "io/assimp_import.h"
#include "io/check_ply.h"
#include "io/endings.h"
#include "io/obj_text.h"
#include "io/read_file.h"
#include "mesh/weld.h"

namespace drape {

namespace {

constexpr std::uint64_t largest_file = 1ULL << 30;  // [bytes]
constexpr double farthest = 1e6;                    // [m]

// assimp triangulates; vertices and their order are those of the text
ImportedScene load_obj(const std::string& path) {
    ObjText obj = read_obj(path, read_file(path, largest_file));
    ImportedScene imported = import_obj(path, obj.plain);
    for (int& corner : imported.soup.faces.reshaped()) {
        const int mark = imported.mark.empty() ? -1 : imported.mark[static_cast<size_t>(corner)];
        if (mark < 0 || mark >= obj.vertices.cols())
            throw Error(cat(path, ": cannot read: assimp lost a vertex"));
        corner = mark;
    }
    imported.soup.positions = std::move(obj.vertices);
    imported.points_lines += obj.points_lines;
    return imported;
}

ImportedScene load_checked(const std::string& path) {
    const std::string ending = ending_of(path);
    if (ending == ".obj") return load_obj(path);
    check_readable(path, largest_file);
    if (ending == ".ply") check_ply(path, read_file(path, largest_file));
    return import_file(path);
}

void check_positions(const std::string& path, const Points& positions) {
    for (Eigen::Index i = 0; i < positions.cols(); ++i) {
        const double reach = positions.col(i).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
        if (!std::isfinite(reach))
            throw Error(cat(path, ": vertex ", i + 1, " of ", positions.cols(), " is not finite"));
        if (reach > farthest)
            throw Error(cat(path, ": vertex ", i + 1, " of ", positions.cols(), " is ", reach,
                            " m from the origin (at most ", farthest, ")"));
    }
}

ImportedScene import_checked(const std::string& path) {
    ImportedScene imported = load_checked(path);
    check_positions(path, imported.soup.positions);
    if (imported.soup.faces.cols() == 0) throw Error(cat(path, ": has no triangles"));
    return imported;
}

}  // namespace

LoadedMesh load_mesh(const std::string& path) {
    try {
        ImportedScene imported = import_checked(path);
        WeldResult welded = weld(imported.soup);
        if (welded.mesh.triangles() == 0)
            throw Error(cat(path, ": all of its ", welded.dropped_zero_area, " triangles have no area"));
        return {std::move(welded.mesh), welded.dropped_zero_area, imported.points_lines,
                welded.unused_vertices, std::move(imported.notes)};
    } catch (const std::bad_alloc&) {
        throw Error(cat(path, ": needs more memory than there is"));
    }
}

LoadedPositions load_positions(const std::string& path) {
    try {
        ImportedScene imported = import_checked(path);
        return {std::move(imported.soup.positions), std::move(imported.notes)};
    } catch (const std::bad_alloc&) {
        throw Error(cat(path, ": needs more memory than there is"));
    }
}

}  // namespace drape
