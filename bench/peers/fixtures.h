// SPDX-License-Identifier: MIT
// fixtures.h -- declares all scenes made by code, and finds them by name.
#ifndef FIXTURES_H
#define FIXTURES_H
#include "fixture.h"

// Returns the fixture of this name, or null if there is none.
const Fixture* fixture_find(const char* name);

// Box2D's benchmarks with joints. Sizes, counts and frequencies are those of shared/benchmarks.c and shared/human.c in
// Erin Catto's Box2D v3, MIT licence.
extern const Fixture joint_grid_fixture; // a net of circles
extern const Fixture rain_fixture;       // ragdolls
extern const Fixture spinner_fixture;    // a motor turns a bar among small bodies
extern const Fixture drum_fixture;       // a motor turns a box full of boxes

extern const Fixture ropes_fixture;    // ropes with a load
extern const Fixture bridges_fixture;  // planks with loads
extern const Fixture beam_fixture;     // welded boxes
extern const Fixture ragdolls_fixture; // ragdolls that come to rest
extern const Fixture car_fixture;      // wheels on rough ground

#endif
