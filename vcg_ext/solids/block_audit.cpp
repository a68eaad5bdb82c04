// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/solids/block_audit.h"

#include "vcg_ext/base/parallel.h"

#include <cmath>

namespace index_boolean {

namespace {

// The volume of each operation's block, NaN if it was not delivered.
using BlockVolumes = std::array<double, kOperationCount>;

// The largest |law| over the laws whose blocks have all been delivered.
double largestLaw(const PerOperand<double>& operand, const BlockVolumes& volumes) {
	const auto of = [&volumes](Operation o) { return volumes[static_cast<std::size_t>(o)]; };
	const double either = of(Operation::Union);
	const double both = of(Operation::Intersection);
	const double firstOnly = of(Operation::FirstMinusSecond);
	const double secondOnly = of(Operation::SecondMinusFirst);
	const double one = of(Operation::SymmetricDifference);
	const double laws[] = {
	    either + both - operand[kFirst] - operand[kSecond],
	    firstOnly + both - operand[kFirst],
	    secondOnly + both - operand[kSecond],
	    either - firstOnly - operand[kSecond],
	    either - secondOnly - operand[kFirst],
	    one - firstOnly - secondOnly,
	    one + 2 * both - operand[kFirst] - operand[kSecond],
	};
	double most = 0;
	for (const double law : laws) {
		most = std::fmax(most, std::fabs(law));  // fmax passes over NaN: a block not delivered
	}
	return most;
}

// A largest |law| over the sum of the operands' volumes.
double residualOf(const Arrangement& arrangement, double most) {
	double whole = 0;
	for (const double volume : arrangement.volume) {
		whole += volume;
	}
	// Of volumes beyond the range of double no law tells anything; closedness is what counts then.
	const double residual = most / whole;
	return std::isfinite(residual) ? residual : 0;
}

}  // namespace

Status measureBlocks(const Arrangement& arrangement, const std::vector<Block>& blocks,
                     Monitor& monitor, std::vector<BlockMeasure>& out) {
	Status status;
	out.clear();
	for (const Block& block : blocks) {
		out.push_back(measureSurface(block.points, block.triangles, arrangement.options.threads));
		if (!out.back().closed) {
			status.code = StatusCode::InternalError;
		}
	}
	if (status.ok() && pollCancelled(monitor)) {
		status.code = StatusCode::Cancelled;
	}
	return status;
}

double lawResidual(const Arrangement& arrangement, const std::vector<Block>& blocks,
                   const std::vector<BlockMeasure>& measures) {
	BlockVolumes volumes;
	volumes.fill(std::nan(""));
	for (std::size_t i = 0; i < blocks.size(); ++i) {
		volumes[static_cast<std::size_t>(blocks[i].operation)] = measures[i].volume;
	}
	return residualOf(arrangement, largestLaw(arrangement.volume, volumes));
}

double cellResidual(const Arrangement& arrangement, const std::vector<CellSet>& cells,
                    const std::vector<BlockMeasure>& measures) {
	double most = 0;
	for (std::size_t i = 0; i < cells.size(); ++i) {
		double volume = 0;
		for (std::size_t cell = 0; cell < cells[i].size(); ++cell) {
			volume += cells[i][cell] != 0 ? arrangement.cells.volume[cell] : 0;
		}
		most = std::fmax(most, std::fabs(measures[i].volume - volume));
	}
	return residualOf(arrangement, most);
}

}  // namespace index_boolean
