#pragma once

#include "microslip/contact/element_grid.hpp"

namespace microslip {

enum class ContactProblem { normal, tangential, second_order, coupled };

/// Upper bound of the memory for NormalProblem or TangentialProblem and its results on a grid of N elements [bytes]. A
/// padded transform has P ~ 2N complex numbers, 16 P bytes, and a table of coefficients ~ 4N real ones, 8 T bytes.
/// Normal: 3 transforms, 1 table and 8 fields, 48 P + 8 T + 64 N, some 190 bytes for an element.
/// Tangential: 18 transforms (steady rolling with the leading edge's correction), 4 tables, 50 fields and the basis of
/// GMRES, 301 vectors of two components: 288 P + 32 T + 400 N + 4816 N, some 5,900 bytes for an element. Most problems
/// need a fifth of that, for the basis grows as it is used.
/// Coupled: 30 transforms, 16 tables, 80 fields, a basis of 301 vectors of three components, and the normal problem.
/// Second order: one transform with real kernels, 64 fields and a basis of 100 vectors, twice what solves have been
/// seen to need, and a third of it all for the coarser grids: some 3,100 bytes for an element.
double memory_need(ContactProblem problem, const ElementGrid& grid);

/// The grid with most elements and the shape of this one, element for element no finer, that needs no more than
/// `memory` [bytes]; the grid itself if it fits. At least one element.
ElementGrid largest_grid(ContactProblem problem, const ElementGrid& grid, double memory);

/// Physical memory of the machine [bytes], in use or not.
double physical_memory();

/// Returns the grid. Throws Error, before anything is allocated, if the grid is not one (see check) or if the problem
/// needs more than the machine's physical memory: the text has both in GiB and the largest grid that fits.
const ElementGrid& require_memory(ContactProblem problem, const ElementGrid& grid);

} // namespace microslip
