// SPDX-License-Identifier: MIT
// small_sizes.h -- defines the number of steps and the settings of each scene, small enough for a test to run on many
// devices. The golden hashes belong to these sizes.
#ifndef SMALL_SIZES_H
#define SMALL_SIZES_H
#include "scene/scene.h"

typedef struct
{
	const char* name;
	int steps;
	SceneSetting settings[6]; // the list ends at an entry without a name
} SmallScene;

static const SmallScene small_scenes[] = {
    {"alarm-clock", 400, {{"clocks", "2"}, {"towers", "1"}}}, // enough steps for a tower to fall
    {"billiards", 300, {{"rack", "10"}}},
    {"blast", 240, {{"towers", "3"}, {"storeys", "5"}}},
    {"bridge", 240, {{"planks", "30"}}},
    {"cars", 240, {{"roads", "3"}}},
    {"cart-pole", 200, {{NULL, NULL}}},
    {"chains", 240, {{"lengths", "4"}}}, // enough for several chains to share a block of MAX_LANES columns
    {"churn", 120, {{"columns", "20"}, {"rows", "16"}, {"moved", "12"}, {"replaced", "30"}}},
    {"city", 240, {{"bodies", "1100"}}}, // enough steps for the ball to reach a house
    {"cloth", 160, {{"columns", "24"}, {"rows", "20"}, {"pins", "4"}}},
    {"coaster", 240, {{"speed", "20"}}}, // m/s: fast enough to pass through the loop
    {"dominoes", 240, {{"lines", "4"}, {"length", "16"}}},
    {"drift", 160, {{"boxes", "400"}}},
    {"gears", 240, {{"columns", "3"}, {"rows", "2"}}},
    {"gripper", 240, {{NULL, NULL}}},
    {"lander", 400, {{NULL, NULL}}},
    {"lidar", 240, {{"robots", "60"}, {"rays", "30"}}},
    {"machine", 240, {{"columns", "3"}}},
    {"million", 120, {{"columns", "2"}, {"rows", "2"}, {"across", "12"}, {"high", "8"}}},
    {"pile", 200, {{"count", "300"}}},
    {"platformer", 400, {{NULL, NULL}}},
    {"platforms", 240, {{"columns", "3"}, {"rows", "4"}, {"jumpers", "20"}}},
    {"pond", 200, {{"boats", "3"}, {"balls", "36"}, {"crates", "12"}, {"fish", "75"}, {"stones", "100"}}},
    {"pusher", 240, {{NULL, NULL}}},
    {"pyramid", 120, {{"rows", "24"}}},
    {"pyramids", 120, {{"columns", "4"}, {"rows", "3"}, {"base", "7"}}},
    {"ragdolls", 240, {{"columns", "5"}, {"rows", "3"}}},
    {"shapes", 240, {{NULL, NULL}}},
    {"slope", 240, {{NULL, NULL}}},
    {"smash", 200, {{"columns", "30"}, {"rows", "20"}, {"speed", "60"}}},
    {"storm", 160, {{"columns", "2"}, {"rows", "1"}, {"across", "12"}}},
    {"tumbler", 240, {{"side", "18"}, {"degrees", "90"}}},
    {"walker", 240, {{NULL, NULL}}},
    {"washer", 160, {{"radius", "13"}, {"plates", "48"}, {"spin", "0.6"}}},
    {"windmill", 240, {{"columns", "3"}, {"rows", "2"}}},
    {"wrecking-ball", 240, {{"links", "8"}, {"columns", "4"}, {"rows", "12"}}},
};

#endif
