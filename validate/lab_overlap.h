// SPDX-License-Identifier: MIT
// lab_overlap.h -- measures the overlaps of the bodies of a lab, and the gaps of its joints.
#ifndef LAB_OVERLAP_H
#define LAB_OVERLAP_H
#include "lab.h"

// Returns the deepest overlap of all bodies, m. If `touches` is not null, sets touches[k] to the number of bodies that
// body k overlaps. All bodies are copied at rest into a new Scree world without gravity, which takes one very short
// step. So the measurement is the same for all engines and does not depend on earlier steps.
double lab_overlap(Lab* lab, int* touches);

// Returns the largest distance between the two anchors of a joint, m, in the state that lab_read has read.
double lab_gap(const Lab* lab);

#endif
