// SPDX-License-Identifier: MIT
// pipeline_soft.h -- the pipeline of libscree: the soft step solver.
#ifndef PIPELINE_SOFT_H
#define PIPELINE_SOFT_H
#include "pipelines.h"

extern const Pipeline soft_pipeline;

#endif
