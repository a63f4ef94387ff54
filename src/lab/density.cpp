// Notes: where the mesh is denser the cloth is stronger, unless springs are made weaker there.
#include "lab/density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/error.h"
#include "base/numbers.h"
#include "lab/elasticity.h"
#include "lab/kinds.h"
#include "lab/plot.h"
#include "scene/fabric_words.h"
#include "study/csv.h"
#include "study/plot_style.h"

namespace drape {

namespace {

constexpr double width = 0.5;   // of the strip; each half is as long [m]
constexpr int rows_shown = 16;  // of the coarse half
constexpr std::array rows_tried{4, 8, 16, 24};
constexpr double pulled = 1;      // strain of the whole; all is linear
constexpr double from_end = 0.2;  // of a half's length, at both its ends, that does not count

// A mesh on a lattice: a vertex per place, however many cells ask for it.
class LatticeMesh {
public:
    explicit LatticeMesh(double spacing) : spacing_(spacing) {}

    int vertex(int i, int j) {
        const auto [at, is_new] = vertices_.try_emplace({j, i}, static_cast<int>(vertices_.size()));
        if (is_new) places_.emplace_back(i * spacing_, 0, j * spacing_);
        return at->second;
    }
    void triangle(int a, int b, int c) { triangles_.emplace_back(a, b, c); }
    Mesh mesh() const {
        Points rest(3, static_cast<Eigen::Index>(places_.size()));
        for (size_t v = 0; v < places_.size(); ++v) rest.col(static_cast<Eigen::Index>(v)) = places_[v];
        Faces faces(3, static_cast<Eigen::Index>(triangles_.size()));
        for (size_t f = 0; f < triangles_.size(); ++f)
            faces.col(static_cast<Eigen::Index>(f)) = triangles_[f];
        return plain_mesh(std::move(rest), std::move(faces));
    }

private:
    double spacing_;
    std::map<std::array<int, 2>, int> vertices_;
    std::vector<Vec3> places_;
    std::vector<Eigen::Vector3i> triangles_;
};

// The square of `size` lattice steps whose first corner is (i, j).
void add_square(LatticeMesh& lattice, int i, int j, int size, bool rising) {
    const int a = lattice.vertex(i, j), b = lattice.vertex(i + size, j);
    const int d = lattice.vertex(i, j + size), c = lattice.vertex(i + size, j + size);
    if (rising) {
        lattice.triangle(a, c, b);
        lattice.triangle(a, d, c);
    } else {
        lattice.triangle(a, d, b);
        lattice.triangle(b, d, c);
    }
}

// The same of size 2 with a vertex in the middle of its last side.
void add_meeting_square(LatticeMesh& lattice, int i, int j) {
    const int a = lattice.vertex(i, j), b = lattice.vertex(i + 2, j), middle = lattice.vertex(i + 2, j + 1);
    const int d = lattice.vertex(i, j + 2), c = lattice.vertex(i + 2, j + 2);
    lattice.triangle(a, middle, b);
    lattice.triangle(a, d, middle);
    lattice.triangle(d, c, middle);
}

double triangle_area(const Mesh& mesh, int f) {
    const Vec3 a = mesh.rest.col(mesh.faces(0, f));
    return (mesh.rest.col(mesh.faces(1, f)) - a).cross(mesh.rest.col(mesh.faces(2, f)) - a).norm() / 2;
}

// Mean strain along the strip of the triangles whose centres lie between two places.
double strain_between(const Mesh& mesh, const Points& move, double from, double to) {
    double strain = 0, area = 0;
    for (int f = 0; f < mesh.triangles(); ++f) {
        double centre = 0;
        for (int k = 0; k < 3; ++k) centre += mesh.rest(0, mesh.faces(k, f)) / 3;
        if (centre < from || centre > to) continue;
        area += triangle_area(mesh, f);
        strain += triangle_area(mesh, f) * strain_of(mesh, f, move)[0];
    }
    return strain / area;
}

LabFigure density_figure(const std::vector<StripPull>& pulls) {
    PanelGrid grid{1, 1, 620, 340};
    grid.right = 200;
    LabFigure figure{
        "density",
        cat("Strain along a strip that is pulled, over its mean: coarse on the left, twice as fine "
            "on the right. Where cloth is stronger it strains less. ",
            rows_shown, " squares across the coarse half."),
        grid.width(),
        grid.height(),
        "",
        grid.begin("A strip half coarse, half fine") + plain_panel() +
            cat("set xrange [", -width, ":", width,
                "]\nset yrange [0.5:1.5]\nset xlabel 'place along the strip [m]'\n"
                "set ylabel 'strain over mean'\n"
                "set key at screen 0.995,0.84 right top Left reverse\n"
                "set arrow 1 from 0,graph 0 to 0,graph 1 nohead lc rgb '#999999' dt (4,4)\n"
                "set label 1 'coarse' at -0.02,graph 0.05 right font ',12'\n"
                "set label 2 'fine' at 0.02,graph 0.05 left font ',12'\n")};
    std::string plot = "plot 1 with lines lc rgb '#999999' notitle";
    for (size_t i = 0; i < pulls.size(); ++i) {
        std::vector<std::array<double, 2>> points;
        for (size_t k = 0; k < pulls[i].place.size(); ++k)
            points.push_back({pulls[i].place[k], pulls[i].strain[k]});
        figure.data += data_block(cat("d", i), points);
        plot += cat(", $d", i, " using 1:2 with lines lw 2.4 lc rgb '", plot_colour(i), "' title ",
                    plot_quoted(pulls[i].law));
    }
    figure.plot += plot + "\nunset multiplot\n";
    return figure;
}

std::string strains_csv(const std::vector<StripPull>& pulls) {
    std::string text = "law,place_m,strain_over_mean\n";
    for (const StripPull& pull : pulls)
        for (size_t k = 0; k < pull.place.size(); ++k)
            text += cat(csv_text(pull.law), ",", csv_number(pull.place[k]), ",", csv_number(pull.strain[k]),
                        "\n");
    return text;
}

}  // namespace

Mesh graded_strip(int rows) {
    LatticeMesh lattice(width / (2 * rows));
    for (int i = -rows; i < 0; ++i) {
        for (int j = 0; j < rows; ++j) {
            if (i == -1)
                add_meeting_square(lattice, 2 * i, 2 * j);
            else
                add_square(lattice, 2 * i, 2 * j, 2, (i + j) % 2 == 0);
        }
    }
    for (int i = 0; i < 2 * rows; ++i)
        for (int j = 0; j < 2 * rows; ++j) add_square(lattice, i, j, 1, (i + j) % 2 == 0);
    return lattice.mesh();
}

std::vector<Law> density_laws() {
    std::vector<Law> laws;
    for (const auto& word : stretch_words) {
        Fabric fabric;
        fabric.stretch_model = word.choice;
        laws.push_back({std::string(word.name), fabric});
    }
    Fabric elements;
    elements.membrane = MembraneKind::stvk;
    laws.push_back({"finite elements", elements});
    return laws;
}

StripPull pull_strip(const Law& law, int rows) {
    const Mesh mesh = graded_strip(rows);
    const Model free = free_cloth(mesh, law.fabric);
    Points pull = Points::Zero(3, mesh.vertices());
    std::vector<int> ends;
    for (int v = 0; v < mesh.vertices(); ++v) {
        pull(0, v) = pulled * mesh.rest(0, v);
        if (std::abs(std::abs(mesh.rest(0, v)) - width) < 1e-9 * width) ends.push_back(v);
    }
    const Points move = settle(free, ends, {pull}).front();
    StripPull result{law.name, {}, {}, 0, 0};
    const double coarse = width / rows;
    for (int i = -rows; i < rows; ++i) {
        result.place.push_back((i + 0.5) * coarse);
        result.strain.push_back(strain_between(mesh, move, i * coarse, (i + 1) * coarse) / pulled);
    }
    const double skip = from_end * width;
    result.coarse = strain_between(mesh, move, -width + skip, -skip) / pulled;
    result.fine = strain_between(mesh, move, skip, width - skip) / pulled;
    return result;
}

double predicted_ratio(const Law& law) {
    const bool by_count = law.fabric.membrane == MembraneKind::none &&
                          law.fabric.stretch_model == StretchModel::force_per_strain;
    return by_count ? 2 : 1;
}

LabResult run_density() {
    std::vector<StripPull> pulls;
    LabTable table{
        {"law", "squares across the coarse half", "strain, coarse over fine", "predicted", "off by [%]"},
        {},
        1};
    LabResult result;
    for (const Law& law : density_laws()) {
        for (const int rows : rows_tried) {
            const StripPull pull = pull_strip(law, rows);
            const double predicted = predicted_ratio(law);
            table.rows.push_back({law.name, figure(rows, 2), figure(pull.ratio(), 4), figure(predicted, 2),
                                  figure(100 * std::abs(pull.ratio() / predicted - 1), 2)});
            if (rows != rows_shown) continue;
            pulls.push_back(pull);
            result.claim += cat(result.claim.empty()
                                    ? "the half of a strip that is twice as fine is so many times as strong: "
                                    : ", ",
                                law.name, " ", figure(pull.ratio()));
        }
    }
    result.story = {
        "With one force per strain k for every spring, as the notes have it, cloth is stronger where the "
        "mesh "
        "is finer: twice as many springs stand side by side. A strip, coarse on its left and twice as fine "
        "on "
        "its right, is held at one end and pulled at the other. Both halves carry the same force, so the "
        "ratio "
        "of their strains is that of their stiffness.",
        "One constant in N/m makes up for it on squares, where half as long springs are half as stiff per "
        "strain; the springs along the free sides, which have no second neighbour to share, leave some per "
        "cent on coarse meshes. Springs spread by area from a modulus in N/m, drape's own choice, know those "
        "too. Where neither works is the seam, whose triangles are of neither kind; finite elements have "
        "none."};
    result.figures = {density_figure(pulls)};
    result.tables = {table};
    result.csv = {{"density", strains_csv(pulls)}};
    return result;
}

}  // namespace drape
