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
int figure5_command(const Options* options); // bench figure5
int figure6_command(const Options* options);
int whole_command(const Options* options, Scene** scenes, int count); // of bench

int view_command(const Options* options);

// The keys of the window; nothing in a build without.
void print_view_help(FILE* file);

int validate_command(const Options* options);
void print_validate_help(FILE* file); // its experiments

#endif
