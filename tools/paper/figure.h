// SPDX-License-Identifier: MIT
// figure.h -- lists the scenes, pipelines and stages of the figures, with their names in the CSV.
#ifndef FIGURE_H
#define FIGURE_H

// Stages, each a column of the CSV: first the stages of the paper and its copies between host and device, then those of
// Scree. If a pipeline lacks a stage, its column is 0.
#define FIGURE_STAGES(X) \
	X(to_device)         \
	X(from_device)       \
	X(integrate)         \
	X(transform)         \
	X(detect)            \
	X(resolve)           \
	X(broad_phase)       \
	X(narrow_phase)      \
	X(color)             \
	X(solve)             \
	X(finalize)

#define FIGURE_STAGE_ID(name) FIGURE_STAGE_##name,
typedef enum
{
	FIGURE_STAGES(FIGURE_STAGE_ID) FIGURE_STAGE_COUNT
} FigureStage;

extern const char* const figure_stages[FIGURE_STAGE_COUNT];

// Scenes and pipelines are measured and drawn in this order.
#define FIGURE_SCENES 2
#define FIGURE_PLACES 3
typedef enum
{
	PAPER_PIPELINE,
	SCREE_PIPELINE,
	FIGURE_PIPELINES
} FigurePipeline;

extern const char* const figure_scenes[FIGURE_SCENES];       // drift, pyramids
extern const char* const figure_pipelines[FIGURE_PIPELINES]; // paper, scree

typedef enum // device and threads of a pipeline
{
	ON_ONE_THREAD,
	ON_THREADS, // more than one thread; only Scree has such a curve
	ON_OPENCL,
} FigurePlace;

#endif
