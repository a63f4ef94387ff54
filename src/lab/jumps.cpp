// Notes: let only the shortest altitude act. The force then jumps where another becomes the shortest.
#include "lab/jumps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/numbers.h"
#include "force/kinds.h"
#include "lab/elastic.h"
#include "lab/kinds.h"
#include "lab/plot.h"
#include "study/csv.h"
#include "study/plot_style.h"

namespace drape {

namespace {

constexpr double base = 1, stretch = 100;  // [m], [N/m]
constexpr double radius = 0.3;             // of the apex's circle, over the base
constexpr int samples = 720;               // of the circle
constexpr double nudge = 1e-9;             // to either side of a tie
constexpr double squeezed = 0.8;           // the tied edges' length over that at rest
constexpr double slack = 1.1;              // how much less the third edge is strained than they are

Mesh triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    Points rest(3, 3);
    rest << a, b, c;
    Faces face(3, 1);
    face << 0, 1, 2;
    return plain_mesh(rest, face);
}

Mesh equilateral() {
    return lone_triangle(base, 0.5, std::sqrt(0.75));
}

// Altitude springs alone, of one triangle.
class Altitudes {
public:
    Altitudes(Mesh mesh, AltitudeMode mode) : model_(free_cloth(std::move(mesh), fabric_with(mode))) {
        forces_.push_back(make_altitude_springs(model_.cloths.front(), {}).force);
    }
    Points force(const Points& x) const { return forces_of(forces_, x); }
    double energy(const Points& x) const { return energy_of(forces_, x); }
    const Points& rest() const { return model_.cloths.front().mesh.rest; }

private:
    static Fabric fabric_with(AltitudeMode mode) {
        Fabric fabric;
        fabric.stretch = stretch;
        fabric.altitude = mode;
        return fabric;
    }
    Model model_;
    std::vector<std::unique_ptr<Force>> forces_;
};

double jump_between(const Altitudes& law, const Points& x, const Points& y) {
    const Points before = law.force(x), after = law.force(y);
    return (after - before).norm() / std::max(before.norm(), after.norm());
}

Points round_rest(const Points& rest, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    Points x = rest;
    x.col(2) += radius * base * Vec3(std::cos(angle), 0, -std::sin(angle));
    return x;
}

// the corner whose altitude is the most compressed: that onto the most stretched edge
int shortest_of(const Points& rest, const Points& x) {
    Eigen::Vector3d stretched;
    for (int k = 0; k < 3; ++k)
        stretched[k] = (x.col((k + 2) % 3) - x.col((k + 1) % 3)).norm() /
                       (rest.col((k + 2) % 3) - rest.col((k + 1) % 3)).norm();
    int corner = 0;
    stretched.maxCoeff(&corner);
    return corner;
}

// Edge lengths 1 and `ratio` from the first corner, `angle` apart.
std::array<Vec3, 3> spread(double one, double other, double angle) {
    return {Vec3::Zero(), Vec3(one, 0, 0), other * Vec3(std::cos(angle), 0, std::sin(angle))};
}

// The angle between edges `a` and `b` of a triangle whose third edge is `c`.
double angle_opposite(double a, double b, double c) {
    return std::acos(std::clamp((a * a + b * b - c * c) / (2 * a * b), -1.0, 1.0));
}

constexpr double unlike = 2;  // the ratio of unlike edges

struct TieRow {
    double angle_deg, alike, unlike, blend;
};

std::vector<TieRow> survey_of_ties() {
    std::vector<TieRow> rows;
    for (int degrees = 10; degrees <= 170; degrees += 2) {
        const double angle = degrees * std::numbers::pi / 180;
        rows.push_back({double(degrees), jump_at_tie(AltitudeMode::shortest, angle, 1),
                        jump_at_tie(AltitudeMode::shortest, angle, unlike),
                        jump_at_tie(AltitudeMode::blend, angle, 1)});
    }
    return rows;
}

LabFigure jumps_figure(const std::vector<JumpSample>& round, const std::vector<TieRow>& ties) {
    const PanelGrid grid{2, 1, 420, 330};
    LabFigure figure{
        "jumps",
        "Left: the altitude springs' force on the apex, along the base, as the apex goes round its "
        "place at rest. Right: how far the force jumps where two altitudes tie, over the force, "
        "against the angle between the edges they stand on.",
        grid.width(),
        grid.height(),
        "",
        grid.begin("The shortest altitude's force jumps") + plain_panel()};
    std::vector<std::array<double, 2>> shortest, blend, alike, uneven, smooth;
    for (size_t i = 0; i < round.size(); ++i) {
        const bool jumped = i > 0 && round[i].corner != round[i - 1].corner;
        if (jumped) shortest.push_back({NAN, NAN});
        shortest.push_back({round[i].turn_deg, round[i].shortest});
        blend.push_back({round[i].turn_deg, round[i].blend});
    }
    for (const TieRow& row : ties) {
        alike.push_back({row.angle_deg, row.alike});
        uneven.push_back({row.angle_deg, row.unlike});
        smooth.push_back({row.angle_deg, row.blend});
    }
    figure.data = data_block("s", shortest) + data_block("b", blend) + data_block("i", alike) +
                  data_block("w", uneven) + data_block("n", smooth);
    const std::string one = plot_colour(1), other = plot_colour(0);
    figure.plot += cat("set xrange [0:360]\nset xtics 60\nset xlabel 'turn of the apex [degrees]'\n",
                       "set ylabel 'force along the base / (E t base)'\nset key top right\n",
                       "plot 0 with lines lc rgb '#999999' notitle, $s using 1:2 with lines lw 2.4 lc rgb '",
                       one, "' title 'shortest', $b using 1:2 with lines lw 2.4 lc rgb '", other,
                       "' title 'blend'\n", "set xrange [0:180]\nset xtics 30\nset yrange [0:2]\n",
                       "set xlabel 'angle between the two edges [degrees]'\nset ylabel 'jump over force'\n",
                       "plot $w using 1:2 with lines lw 2.4 dt (5,3) lc rgb '", one,
                       "' title 'shortest, edges 1 : 2', $i using 1:2 with lines lw 2.4 lc rgb '", one,
                       "' title 'shortest, edges alike', $n using 1:2 with lines lw 2.4 lc rgb '", other,
                       "' title 'blend'\nunset multiplot\n");
    return figure;
}

std::string round_csv(const std::vector<JumpSample>& round) {
    std::string text = "turn_deg,force_shortest,force_blend,energy_shortest,energy_blend\n";
    for (const JumpSample& sample : round)
        text +=
            cat(csv_number(sample.turn_deg), ",", csv_number(sample.shortest), ",", csv_number(sample.blend),
                ",", csv_number(sample.energy_shortest), ",", csv_number(sample.energy_blend), "\n");
    return text;
}

std::string ties_csv(const std::vector<TieRow>& ties) {
    std::string text = "angle_deg,jump_shortest_edges_alike,jump_shortest_edges_1_to_2,jump_blend\n";
    for (const TieRow& row : ties)
        text += cat(csv_number(row.angle_deg), ",", csv_number(row.alike), ",", csv_number(row.unlike), ",",
                    csv_number(row.blend), "\n");
    return text;
}

}  // namespace

std::vector<JumpSample> forces_round_rest() {
    const Altitudes shortest(equilateral(), AltitudeMode::shortest);
    const Altitudes blend(equilateral(), AltitudeMode::blend);
    std::vector<JumpSample> round;
    for (int i = 0; i <= samples; ++i) {
        const double degrees = 360.0 * i / samples;
        const Points x = round_rest(shortest.rest(), degrees);
        round.push_back({shortest_of(shortest.rest(), x), degrees, shortest.force(x)(0, 2) / (stretch * base),
                         blend.force(x)(0, 2) / (stretch * base),
                         shortest.energy(x) / (stretch * base * base),
                         blend.energy(x) / (stretch * base * base)});
    }
    return round;
}

std::vector<ForceJump> jumps_round_rest() {
    const Altitudes shortest(equilateral(), AltitudeMode::shortest);
    const Altitudes blend(equilateral(), AltitudeMode::blend);
    const Points& rest = shortest.rest();
    const auto chosen = [&](double degrees) { return shortest_of(rest, round_rest(rest, degrees)); };
    std::vector<ForceJump> jumps;
    // half a sample off, so that no tie by symmetry falls on a sample
    const double apart = 360.0 / samples;
    for (int i = 0; i < samples; ++i) {
        double before = (i + 0.5) * apart, after = before + apart;
        if (chosen(before) == chosen(after)) continue;
        while (after - before > 360 * nudge) {
            const double middle = (before + after) / 2;
            (chosen(middle) == chosen(before) ? before : after) = middle;
        }
        const Points x = round_rest(rest, before), y = round_rest(rest, after);
        jumps.push_back({after, jump_between(shortest, x, y), jump_between(blend, x, y),
                         std::abs(shortest.energy(y) - shortest.energy(x)) / shortest.energy(x)});
    }
    return jumps;
}

double jump_at_tie(AltitudeMode mode, double angle, double ratio) {
    const double third = std::sqrt(1 + ratio * ratio - 2 * ratio * std::cos(angle));
    // longer at rest than the tied edges make it, as far as a triangle can be
    const double rest_third = third * std::min(slack, (1 + (1 + ratio) / third) / 2);
    const auto rest = spread(1 / squeezed, ratio / squeezed, angle_opposite(1, ratio, rest_third));
    const Altitudes law(triangle(rest[0], rest[1], rest[2]), mode);
    const auto pose = [&](double more) {
        const auto corner = spread(1 + more, ratio * (1 - more), angle);
        Points x(3, 3);
        x << corner[0], corner[1], corner[2];
        return x;
    };
    return jump_between(law, pose(-nudge), pose(nudge));
}

LabResult run_jumps() {
    const std::vector<TieRow> ties = survey_of_ties();
    const std::vector<ForceJump> jumps = jumps_round_rest();
    LabTable table{{"turn of the apex [degrees]", "shortest: jump over force", "blend: jump over force",
                    "shortest: change of energy"},
                   {},
                   0};
    for (const ForceJump& jump : jumps)
        table.rows.push_back({figure(jump.turn_deg, 4), figure(jump.shortest), figure(jump.blend, 1),
                              figure(jump.energy_change, 1)});
    const TieRow greatest = *std::max_element(
        ties.begin(), ties.end(), [](const TieRow& a, const TieRow& b) { return a.alike < b.alike; });
    double blend = 0;
    for (const TieRow& row : ties) blend = std::max(blend, row.blend);
    LabResult result;
    result.claim = cat("where it changes its altitude the force of `shortest` jumps by up to ",
                       figure(greatest.alike), " of itself (edges ", figure(greatest.angle_deg),
                       " degrees apart); that of `blend` changes by ", figure(blend, 1), " there");
    result.story = {
        "Three altitude springs in a triangle fight each other, so the notes let only the shortest act. "
        "drape "
        "chooses it by its strain, with one energy for the triangle, so that the energy at least does not "
        "jump "
        "where the choice changes. The force does: a moment ago it pulled at one corner, now at another.",
        "On the left the apex of an equilateral triangle goes round its place at rest, and the choice "
        "changes "
        "three times. On the right two altitudes tie in triangles of every angle; edges of one length make "
        "the worst of it. Every jump costs an integrator its order and an implicit method its Newton steps. "
        "`blend` puts one smooth function of all edges in the choice's place."};
    result.figures = {jumps_figure(forces_round_rest(), ties)};
    result.tables = {table};
    result.csv = {{"jumps", round_csv(forces_round_rest())}, {"jumps_at_ties", ties_csv(ties)}};
    return result;
}

}  // namespace drape
