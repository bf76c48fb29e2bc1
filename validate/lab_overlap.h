// SPDX-License-Identifier: MIT
// lab_overlap.h -- measures how deep the bodies of a lab overlap, and how far its joints are open.
#ifndef LAB_OVERLAP_H
#define LAB_OVERLAP_H
#include "lab.h"

// The deepest overlap of all bodies, m, and the number of others that each body overlaps (touches has a place for each, or is null). All
// poses are copied into a new Scree world, at rest and without gravity, which takes one very short step. So the measurement is the same
// for all engines and does not depend on earlier ones.
double lab_overlap(Lab* lab, int* touches);

// The largest distance between the two anchors of a joint, m, in the last state that lab_read has read.
double lab_gap(const Lab* lab);

#endif
