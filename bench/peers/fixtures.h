// SPDX-License-Identifier: MIT
// fixtures.h -- all scenes made by code.
#ifndef FIXTURES_H
#define FIXTURES_H
#include "fixture.h"

// Box2D's benchmarks with joints. Sizes, counts and frequencies are those of shared/benchmarks.c and shared/human.c in
// Erin Catto's Box2D v3, MIT licence.
extern const Rig joint_grid_rig; // a net of circles
extern const Rig rain_rig;       // ragdolls
extern const Rig spinner_rig;    // a motor turns a bar among small bodies
extern const Rig drum_rig;       // a motor turns a box full of boxes

extern const Rig ropes_rig;   // ropes with a load
extern const Rig bridges_rig; // planks with loads
extern const Rig beam_rig;    // welded boxes
extern const Rig humans_rig;  // ragdolls that come to rest
extern const Rig car_rig;     // wheels on rough ground

#endif
