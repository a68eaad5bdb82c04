// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What all filters that make blocks have in common: parameters in, layers and messages out.
#pragma once

#include "attributes/attribute_transfer.h"
#include "layers/layers.h"
#include "layers/operand_layers.h"
#include "runs/block_run.h"
#include "texts/parameter_values.h"

#include <memory>
#include <string>
#include <vector>

namespace index_boolean {

// The options of a filter that makes blocks.
Options readBlockOptions(FilterId filter, const ParameterValues& values);

// What carries the layers' attributes over, if that is wanted, else nullptr. Borrows the layers;
// completes the request and the arrays by what it needs.
std::unique_ptr<AttributeTransfer> attributeTransfer(const ParameterValues& values,
                                                     const OperandLayers& operands,
                                                     BlocksRequest& request, OperandArrays& read);

// A layer for each block. Borrows the result and the transfer.
// \param labels   of the blocks
// \param transfer nullptr: no attributes are wanted
std::vector<LayerContent> blockContents(const BlocksResult& result,
                                        const std::vector<std::string>& labels,
                                        const AttributeTransfer* transfer);

std::vector<int> idsOf(const std::vector<MeshModel*>& layers);

// Adds a sentence for each block of which walls have been merged, and for each that is not
// certified, or one for all.
void addCertificateMessages(const BlocksResult& result, const std::vector<std::string>& labels,
                            OutputScalar scalar, std::vector<std::string>& messages);

}  // namespace index_boolean
