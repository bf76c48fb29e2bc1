// SPDX-License-Identifier: MIT
// commands.h -- the commands of scree; each returns an exit code.
#ifndef COMMANDS_H
#define COMMANDS_H
#include "options.h"

int run_command(const Options* options);
int hash_command(const Options* options);
int scenes_command(const Options* options);
int devices_command(const Options* options);
int bench_command(const Options* options);
int frames_command(const Options* options);  // bench frames
int queries_command(const Options* options); // bench queries
int figure5_command(const Options* options); // bench figure5
int figure6_command(const Options* options);
int view_command(const Options* options);
int validate_command(const Options* options);

#endif
