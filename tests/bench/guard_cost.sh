#!/usr/bin/env bash
# What the guard (src/simulate/guard.h) costs, as a share of the instructions of a simulation: counted by valgrind,
# so that any machine gives the same figure. Needs valgrind.
#   tests/bench/guard_cost.sh [PROGRAM]
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
program=${1:-build/release/drape}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# instructions FUNCTIONS...: with all that they call
instructions() {
    callgrind_annotate --inclusive=yes --threshold=100 "$folder/counts" 2>/dev/null |
        awk -v names="$*" 'BEGIN { split(names, name, " ") }
            { for (i in name) if (index($0, "drape::" name[i])) { gsub(",", "", $1); sum += $1 } }
            END { print sum + 0 }'
}

# share SCENE SECONDS
share() {
    valgrind --quiet --tool=callgrind --callgrind-out-file="$folder/counts" "$program" simulate "$1" \
        --set scene.duration="$2" --no-estimate --quiet --threads 1 --out "$folder/out" >/dev/null 2>&1
    local guard all
    guard=$(instructions 'Guard::begin_frame(' 'Guard::step_holds(' 'Guard::gain(')
    all=$(instructions 'Simulation::next_frame()')
    awk -v scene="$1" -v guard="$guard" -v all="$all" \
        'BEGIN { printf "%-16s %6.2f %% of %.3g instructions\n", scene, 100 * guard / all, all }'
}

share bare_springs 0.1
share hanging_swatch 0.2
share sphere_drop 0.1
