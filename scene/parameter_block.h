// SPDX-License-Identifier: MIT
// parameter_block.h -- reads the parameters and constants of a scene: names that its expressions use.
#ifndef PARAMETER_BLOCK_H
#define PARAMETER_BLOCK_H
#include "scene/reader.h"
#include "scene/scene.h"

// Reads "parameters" and adds their names to the scope. count: number of settings. A parameter with a setting gets the
// value of the setting, any other parameter its default.
bool parameters_read(Reader* reader, const json_t* root, const SceneSetting* settings, int count);

// Reads "constants" and adds their names to the scope.
bool constants_read(Reader* reader, const json_t* root);

#endif
