// The words a scene uses for a fabric's choices, for reading and for printing.
#pragma once

#include <array>
#include <string_view>

#include "cloth/fabric.h"

namespace drape {

template <class Choice>
struct Word {
    std::string_view name;
    Choice choice;
    std::string_view summary = "";
};

inline constexpr std::array stretch_words{
    Word<StretchModel>{"force_per_strain", StretchModel::force_per_strain},
    Word<StretchModel>{"spring_constant", StretchModel::spring_constant},
    Word<StretchModel>{"membrane", StretchModel::membrane},
};

inline constexpr std::array altitude_words{
    Word<AltitudeMode>{"none", AltitudeMode::none},
    Word<AltitudeMode>{"all", AltitudeMode::all},
    Word<AltitudeMode>{"shortest", AltitudeMode::shortest},
    Word<AltitudeMode>{"compressed", AltitudeMode::compressed},
    Word<AltitudeMode>{"blend", AltitudeMode::blend},
};

inline constexpr std::array membrane_words{
    Word<MembraneKind>{"none", MembraneKind::none, "springs along edges and altitudes"},
    Word<MembraneKind>{"stvk", MembraneKind::stvk,
                       "St. Venant-Kirchhoff: linear in Green's strain; gives way below 58 % of its length"},
    Word<MembraneKind>{"neo_hookean", MembraneKind::neo_hookean,
                       "stable neo-Hookean: resists compression to the end"},
};

inline constexpr std::array bending_words{
    Word<BendingKind>{"none", BendingKind::none},
    Word<BendingKind>{"plate", BendingKind::plate},
    Word<BendingKind>{"hinge", BendingKind::hinge},
    Word<BendingKind>{"spring", BendingKind::spring},
};

// The word for a choice.
template <class Words, class Choice>
std::string_view word_for(const Words& words, Choice choice) {
    for (const auto& word : words)
        if (word.choice == choice) return word.name;
    return "";
}

}  // namespace drape
