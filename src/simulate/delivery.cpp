#include "simulate/delivery.h"

#include "simulate/budgeted_delivery.h"
#include "simulate/controlled_delivery.h"
#include "simulate/streamed_delivery.h"

namespace drape {

std::unique_ptr<Delivery> make_delivery(Setup setup, const DeliveryOptions& options) {
    if (options.tolerance) return std::make_unique<ControlledDelivery>(std::move(setup), options);
    if (options.budget) return std::make_unique<BudgetedDelivery>(std::move(setup), options);
    return std::make_unique<StreamedDelivery>(std::move(setup), options);
}

}  // namespace drape
