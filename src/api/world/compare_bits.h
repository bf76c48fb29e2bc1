// SPDX-License-Identifier: MIT
// compare_bits.h -- compares the bits of a device with those of the CPU.
#ifndef COMPARE_BITS_H
#define COMPARE_BITS_H
#include "backend/backend.h"

// Steps a sample world on the device and on the CPU. Fails if the hashes differ; else clears all pools of the device.
scree_status compare_bits(Backend* backend);

#endif
