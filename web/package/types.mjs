// SPDX-License-Identifier: MIT
// types.mjs -- the TypeScript declarations of the package: comments of scree.h become TSDoc.
export function types() { return ""; }
