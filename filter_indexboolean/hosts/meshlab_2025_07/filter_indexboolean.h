// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The plugin as MeshLab and pymeshlab 2025.07 see it: filter_definitions.h in their terms.
#pragma once

#include <common/plugins/interfaces/filter_plugin.h>

class FilterIndexBoolean : public QObject, public FilterPlugin {
	Q_OBJECT
	MESHLAB_PLUGIN_IID_EXPORTER(FILTER_PLUGIN_IID)
	Q_INTERFACES(FilterPlugin)

public:
	FilterIndexBoolean();

	QString pluginName() const override;
	QString vendor() const override;
	QString filterName(ActionIDType filter) const override;
	QString pythonFilterName(ActionIDType filter) const override;
	QString filterInfo(ActionIDType filter) const override;
	FilterClass getClass(const QAction* action) const override;
	FilterArity filterArity(const QAction* action) const override;
	int getPreConditions(const QAction* action) const override;
	int postCondition(const QAction* action) const override;
	RichParameterList initParameterList(const QAction* action,
	                                    const MeshDocument& document) override;

	// Every refusal, and whatever else is thrown, leaves as one MLException.
	std::map<std::string, QVariant>
	applyFilter(const QAction* action, const RichParameterList& parameters, MeshDocument& document,
	            unsigned int& postConditionMask, vcg::CallBackPos* callback) override;
};
