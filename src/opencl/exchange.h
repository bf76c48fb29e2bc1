// SPDX-License-Identifier: MIT
// exchange.h -- many items to a GPU, a stage over each, and the answers back: three things at a time.
#ifndef OPENCL_EXCHANGE_H
#define OPENCL_EXCHANGE_H
#include "opencl/state.h"

scree_status opencl_exchange(Backend* b, const Step* step, const Exchange* exchange);
void exchange_close(OpenCl* d);

#endif
