// SPDX-License-Identifier: MIT
// each_backend.h -- opens all backends of this machine, so that a test can run single kernels on its own items.
#ifndef EACH_BACKEND_H
#define EACH_BACKEND_H
#include "backend/backend.h"
#include "support/checks.h"

#define MAX_BACKENDS 16
#define MOST_BODIES  4096
#define MOST_ITEMS   70000 // capacity of all pools except those of bodies

extern Backend* backends[MAX_BACKENDS];
extern int backend_count;

// Opens the CPU with one thread, the CPU with three threads, and the OpenCL devices. room_of: returns the capacity of
// the pools of a kind.
void open_backends(bool allow_unequal_bits, int (*room_of)(Per per));

// Set-up and tear-down for tests of stages. The set-up opens the devices whose results have the same bits as those of
// the CPU, with room for MOST_BODIES and MOST_ITEMS.
int open_stage_backends(void** state);
int close_backends(void** state);

void put_items(Backend* b, PoolId pool, int count, const void* items);
void get_items(Backend* b, PoolId pool, int count, void* items);
void run_one(Backend* b, const Step* step, int kernel, int end, int count, int argument);
void run_sort(Backend* b, int end, int low_bit, int high_bit);

#endif
