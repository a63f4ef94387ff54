// A run as its user gets it, kept whole: positions and stated errors of every frame, and what it cost.
#pragma once

#include <string>
#include <vector>

#include "simulate/delivery.h"

namespace drape::bench {

struct Delivered {
    std::vector<Points> x = {};       // per frame
    std::vector<double> stated = {};  // RMS, per frame [m]
    ErrorAccount error = {};
    std::string method = {};
    std::string trouble = {};  // "" = good
    double cpu = 0;            // of all passes and set-up, on one thread [s]
    double twin = 0;           // of the predictability twin, not counted in `cpu` [s]
};

Delivered deliver(const Setup& setup, const DeliveryOptions& options);

}  // namespace drape::bench
