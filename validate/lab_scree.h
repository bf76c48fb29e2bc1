// SPDX-License-Identifier: MIT
// lab_scree.h -- Scree as the engine of a lab.
#ifndef LAB_SCREE_H
#define LAB_SCREE_H
#include "validation.h"

extern const LabEngine scree_lab;

// A definition of a world on the device, and with the threads and lanes, of the options.
scree_world_def scree_lab_world_def(const LabOptions* options);

// The counters of Scree's last step; state is that of scree_lab.
bool scree_lab_counters(void* state, scree_counters* counters);
// How many bodies a body overlaps.
int scree_lab_touches(void* state, int body);

#endif
