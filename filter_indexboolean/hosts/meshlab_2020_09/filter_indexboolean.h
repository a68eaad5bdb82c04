// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The plugin as MeshLab and meshlabserver 2020.09 see it: filter_definitions.h in their terms.
#pragma once

#include <common/interfaces.h>

class FilterIndexBoolean : public QObject, public MeshFilterInterface {
	Q_OBJECT
	MESHLAB_PLUGIN_IID_EXPORTER(MESH_FILTER_INTERFACE_IID)
	Q_INTERFACES(MeshFilterInterface)

public:
	FilterIndexBoolean();

	using MeshFilterInterface::filterInfo;
	using MeshFilterInterface::filterName;
	using MeshFilterInterface::initParameterSet;

	QString pluginName() const override;
	QString filterName(FilterIDType filter) const override;
	QString filterInfo(FilterIDType filter) const override;
	QString filterScriptFunctionName(FilterIDType filter) override;
	FilterClass getClass(QAction* action) override;
	FILTER_ARITY filterArity(QAction* action) const override;
	int postCondition(QAction* action) const override;
	void initParameterSet(QAction* action, MeshDocument& document,
	                      RichParameterList& list) override;

	// No exception leaves it, since none is caught outside. A failure's sentence is in the log too:
	// meshlabserver prints nothing else of it.
	// \return false if there are no new layers
	bool applyFilter(QAction* action, MeshDocument& document, const RichParameterList& parameters,
	                 vcg::CallBackPos* callback) override;
};
