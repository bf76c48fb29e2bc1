// SPDX-License-Identifier: MIT
// figure.h -- the scenes, pipelines and stages of the figures, as their CSV names them.
#ifndef FIGURE_H
#define FIGURE_H

// Columns of stages: those of the paper, with its copies over the bus, then those of Scree. Stages that a pipeline lacks are 0.
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

// Scenes and pipelines in the order in which they are measured and drawn.
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

typedef enum // the device on which a pipeline runs
{
	ON_ONE_THREAD,
	ON_THREADS, // more than one; the paper's pipeline has no such curve
	ON_OPENCL,
} FigurePlace;

#endif
