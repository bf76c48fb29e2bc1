// SPDX-License-Identifier: MIT
// pipeline_paper.h -- the pipeline of the paper, tools/paper/paper.h.
#ifndef PIPELINE_PAPER_H
#define PIPELINE_PAPER_H
#include "pipelines.h"

extern const Pipeline paper_pipeline;

#endif
