// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One row an attribute: which mask bit says that a layer has it, and how its values are read and
// written.
#include "attributes/layer_attributes.h"

#include <algorithm>
#include <map>
#include <typeindex>

namespace index_boolean {

namespace {

using TexCoord = CVertexO::TexCoordType;
using Wedge = CFaceO::TexCoordType;

// The rows of a matrix without its translation.
std::array<Point3m, 3> rowsOf(const Matrix44m& matrix) {
	std::array<Point3m, 3> rows;
	for (int row = 0; row < 3; ++row) {
		rows[static_cast<std::size_t>(row)] = {matrix[row][0], matrix[row][1], matrix[row][2]};
	}
	return rows;
}

// A direction turned by a matrix, as long as before.
Point3m turnedDirection(const std::array<Point3m, 3>& rows, const Point3m& direction) {
	const Point3m turned(rows[0] * direction, rows[1] * direction, rows[2] * direction);
	const Scalarm length = turned.Norm();
	return length > 0 ? turned * (direction.Norm() / length) : turned;
}

// The columns that are found, one after another.
class ColumnList {
public:
	ColumnList(const OperandElementsAccess& access, const TextureList& textures,
	           const std::vector<const char*>& reserved)
	    : access_(access), textures_(textures), reserved_(reserved) {}

	void addVertexComponents();
	void addFaceComponents();
	void addTextureCoordinates();
	void addSelection();
	template <class Value>
	void addUserAttributes(Value missing);

	std::vector<AttributeColumn> columns;

private:
	// Which operands it is true of; has(operand).
	template <class Has>
	PerOperand<bool> which(Has&& has) const {
		PerOperand<bool> all(access_.operands().count());
		for (const OperandId operand : all.operands()) {
			all[operand] = has(operand);
		}
		return all;
	}
	PerOperand<bool> haveMask(int bit) const {
		return which([&](OperandId operand) { return access_.layer(operand).hasDataMask(bit); });
	}
	void add(AttributeColumn column) {
		if (std::find(column.has.begin(), column.has.end(), true) != column.has.end()) {
			columns.push_back(std::move(column));
		}
	}
	template <class Value, class Get, class Put>
	void addVertices(const char* name, int bit, Value missing, Get get, Put put);
	template <class Value, class Get, class Put>
	void addFaces(const char* name, int bit, Value missing, Get get, Put put);
	template <class Value, class AttributesOf, class Add>
	void addAttributesOf(AttributesOf&& attributesOf, Add&& add);
	template <class Value>
	void addVertexAttribute(const std::string& name, Value missing);
	template <class Value>
	void addFaceAttribute(const std::string& name, Value missing);

	const OperandElementsAccess& access_;
	const TextureList& textures_;
	const std::vector<const char*>& reserved_;
};

// \param get get(vertex, matrix of its layer); put(vertex, value): of MeshLab's vertices
template <class Value, class Get, class Put>
void ColumnList::addVertices(const char* name, int bit, Value missing, Get get, Put put) {
	add(vertexColumn<Value>(
	    access_, name, haveMask(bit), missing,
	    [&access = access_, get](OperandId operand, std::size_t v) {
		    const CMeshO& mesh = access.mesh(operand);
		    return Value(get(mesh.vert[v], mesh.Tr));
	    },
	    [bit, put](MeshModel& layer, const AttributeSources&) {
		    layer.updateDataMask(bit);
		    return
		        [&layer, put](std::size_t v, const Value& value) { put(layer.cm.vert[v], value); };
	    }));
}

template <class Value, class Get, class Put>
void ColumnList::addFaces(const char* name, int bit, Value missing, Get get, Put put) {
	add(faceColumn<Value>(
	    access_, name, haveMask(bit), missing,
	    [&access = access_, get](OperandId operand, std::size_t f) {
		    const CMeshO& mesh = access.mesh(operand);
		    return Value(get(mesh.face[f], mesh.Tr));
	    },
	    [bit, put](MeshModel& layer, const AttributeSources&) {
		    layer.updateDataMask(bit);
		    return
		        [&layer, put](std::size_t f, const Value& value) { put(layer.cm.face[f], value); };
	    }));
}

template <class Element>
CurvatureValue curvatureOf(const Element& element) {
	return {element.cPD1(), element.cPD2(), static_cast<Scalarm>(element.cK1()),
	        static_cast<Scalarm>(element.cK2())};
}

template <class Element>
void setCurvature(Element& element, const CurvatureValue& value) {
	element.PD1() = value.direction1;
	element.PD2() = value.direction2;
	element.K1() = value.k1;
	element.K2() = value.k2;
}

CurvatureValue moved(const Matrix44m& matrix, CurvatureValue value) {
	if (matrix != Matrix44m::Identity()) {
		value.direction1 = turnedDirection(rowsOf(matrix), value.direction1);
		value.direction2 = turnedDirection(rowsOf(matrix), value.direction2);
	}
	return value;
}

void ColumnList::addVertexComponents() {
	using Quality = CVertexO::QualityType;
	addVertices<vcg::Color4b>(
	    "vertex colours", MeshModel::MM_VERTCOLOR, vcg::Color4b(vcg::Color4b::White),
	    [](const CVertexO& v, const Matrix44m&) { return v.cC(); },
	    [](CVertexO& v, const vcg::Color4b& value) { v.C() = value; });
	addVertices<Quality>(
	    "vertex qualities", MeshModel::MM_VERTQUALITY, Quality(0),
	    [](const CVertexO& v, const Matrix44m&) { return v.cQ(); },
	    [](CVertexO& v, Quality value) { v.Q() = value; });
	addVertices<Scalarm>(
	    "vertex radii", MeshModel::MM_VERTRADIUS, Scalarm(0),
	    [](const CVertexO& v, const Matrix44m&) { return v.cR(); },
	    [](CVertexO& v, Scalarm value) { v.R() = value; });
	addVertices<CurvatureValue>(
	    "vertex curvature directions", MeshModel::MM_VERTCURVDIR, CurvatureValue{},
	    [](const CVertexO& v, const Matrix44m& matrix) { return moved(matrix, curvatureOf(v)); },
	    [](CVertexO& v, const CurvatureValue& value) { setCurvature(v, value); });
}

void ColumnList::addFaceComponents() {
	using Quality = CFaceO::QualityType;
	addFaces<vcg::Color4b>(
	    "face colours", MeshModel::MM_FACECOLOR, vcg::Color4b(vcg::Color4b::White),
	    [](const CFaceO& f, const Matrix44m&) { return f.cC(); },
	    [](CFaceO& f, const vcg::Color4b& value) { f.C() = value; });
	addFaces<Quality>(
	    "face qualities", MeshModel::MM_FACEQUALITY, Quality(0),
	    [](const CFaceO& f, const Matrix44m&) { return f.cQ(); },
	    [](CFaceO& f, Quality value) { f.Q() = value; });
	addFaces<CurvatureValue>(
	    "face curvature directions", MeshModel::MM_FACECURVDIR, CurvatureValue{},
	    [](const CFaceO& f, const Matrix44m& matrix) { return moved(matrix, curvatureOf(f)); },
	    [](CFaceO& f, const CurvatureValue& value) { setCurvature(f, value); });
}

void ColumnList::addTextureCoordinates() {
	TexCoord missing(0, 0);
	missing.N() = 0;
	add(vertexColumn<TexCoord>(
	    access_, "vertex texture coordinates", haveMask(MeshModel::MM_VERTTEXCOORD), missing,
	    [&access = access_, &textures = textures_](OperandId operand, std::size_t v) {
		    TexCoord coordinate = access.mesh(operand).vert[v].cT();
		    coordinate.N() = std::max(textures.number(operand, coordinate.N()), short{0});
		    return coordinate;
	    },
	    [](MeshModel& layer, const AttributeSources&) {
		    layer.updateDataMask(MeshModel::MM_VERTTEXCOORD);
		    return [&layer](std::size_t v, const TexCoord& value) { layer.cm.vert[v].T() = value; };
	    }));
	Wedge none(0.5, 0.5);  // as MeshLab makes them
	none.N() = -1;
	add(cornerColumn<Wedge>(
	    access_, "wedge texture coordinates", haveMask(MeshModel::MM_WEDGTEXCOORD), none,
	    [&access = access_, &textures = textures_](OperandId operand, std::size_t f,
	                                               std::size_t corner) {
		    Wedge coordinate = access.mesh(operand).face[f].cWT(static_cast<int>(corner));
		    coordinate.N() = textures.number(operand, coordinate.N());
		    return coordinate;
	    },
	    [](MeshModel& layer, const AttributeSources&) {
		    layer.updateDataMask(MeshModel::MM_WEDGTEXCOORD);
		    return [&layer](std::size_t f, std::size_t corner, const Wedge& value) {
			    layer.cm.face[f].WT(static_cast<int>(corner)) = value;
		    };
	    }));
}

void ColumnList::addSelection() {
	add(vertexColumn<bool>(
	    access_, "",
	    which([&](OperandId operand) { return access_.elements(operand).anyVertexSelected; }),
	    false,
	    [&access = access_](OperandId operand, std::size_t v) {
		    return access.mesh(operand).vert[v].IsS();
	    },
	    [](MeshModel& layer, const AttributeSources&) {
		    return [&layer](std::size_t v, bool selected) {
			    if (selected) {
				    layer.cm.vert[v].SetS();
			    }
		    };
	    }));
	add(faceColumn<bool>(
	    access_, "",
	    which([&](OperandId operand) { return access_.elements(operand).anyFaceSelected; }), false,
	    [&access = access_](OperandId operand, std::size_t f) {
		    return access.mesh(operand).face[f].IsS();
	    },
	    [](MeshModel& layer, const AttributeSources&) {
		    return [&layer](std::size_t f, bool selected) {
			    if (selected) {
				    layer.cm.face[f].SetS();
			    }
		    };
	    }));
}

// Where each operand's vertices are among those as given.
OperandOffsets verticesOf(const PerOperand<OperandElements>& elements) {
	OperandOffsets offsets(elements.size());
	for (const OperandId operand : elements.operands()) {
		offsets.setEnd(operand, offsets.begin(operand) + elements[operand].vertices.count);
	}
	return offsets;
}

template <class Value>
bool isOf(const vcg::PointerToAttribute& attribute) {
	return !attribute._name.empty() && attribute._type == std::type_index(typeid(Value));
}

// A user's attribute of that name and type as each operand has it, or nullptr.
struct AttributeArrays {
	PerOperand<const vcg::SimpleTempDataBase*> of;

	// \param attributesOf attributesOf(operand): all that the operand's vertices, or faces, have
	template <class Value, class AttributesOf>
	static AttributeArrays find(const std::string& name, Operands operands,
	                            AttributesOf&& attributesOf) {
		AttributeArrays found{PerOperand<const vcg::SimpleTempDataBase*>(operands.count())};
		for (const OperandId operand : operands) {
			for (const vcg::PointerToAttribute& a : attributesOf(operand)) {
				if (isOf<Value>(a) && a._name == name) {
					found.of[operand] = a._handle;
				}
			}
		}
		return found;
	}
	template <class Value>
	Value at(OperandId operand, std::size_t position) const {
		return *static_cast<const Value*>(of[operand]->At(position));
	}
};

template <class Value>
void ColumnList::addVertexAttribute(const std::string& name, Value missing) {
	const AttributeArrays arrays = AttributeArrays::find<Value>(
	    name, access_.operands(), [this](OperandId o) -> const auto& {
		    return access_.mesh(o).vert_attr;
	    });
	add(vertexColumn<Value>(
	    access_, "vertex attribute \"" + name + "\"",
	    which([&](OperandId operand) { return arrays.of[operand] != nullptr; }), missing,
	    [arrays](OperandId operand, std::size_t v) { return arrays.at<Value>(operand, v); },
	    [name](MeshModel& layer, const AttributeSources& sources) {
		    auto out =
		        index_boolean::addVertexAttribute<Value>(name, sources.vertex.size(), layer.cm);
		    return [out](std::size_t v, const Value& value) mutable { out[v] = value; };
	    }));
}

template <class Value>
void ColumnList::addFaceAttribute(const std::string& name, Value missing) {
	const AttributeArrays arrays = AttributeArrays::find<Value>(
	    name, access_.operands(), [this](OperandId o) -> const auto& {
		    return access_.mesh(o).face_attr;
	    });
	add(faceColumn<Value>(
	    access_, "face attribute \"" + name + "\"",
	    which([&](OperandId operand) { return arrays.of[operand] != nullptr; }), missing,
	    [arrays](OperandId operand, std::size_t f) { return arrays.at<Value>(operand, f); },
	    [name](MeshModel& layer, const AttributeSources& sources) {
		    auto out = index_boolean::addFaceAttribute<Value>(name, sources.face.size(), layer.cm);
		    return [out](std::size_t f, const Value& value) mutable { out[f] = value; };
	    }));
}

// An attribute that operands have under one name with different types is that of the first of them.
template <class Value, class AttributesOf, class Add>
void ColumnList::addAttributesOf(AttributesOf&& attributesOf, Add&& add) {
	std::map<std::string, bool> names;  // of all types; whether it is of this one
	for (const OperandId operand : access_.operands()) {
		for (const vcg::PointerToAttribute& attribute : attributesOf(operand)) {
			if (!attribute._name.empty()) {
				names.emplace(attribute._name, isOf<Value>(attribute));
			}
		}
	}
	for (const auto& [name, isOfThisType] : names) {
		const bool isTaken = std::find(reserved_.begin(), reserved_.end(), name) != reserved_.end();
		if (isOfThisType && !isTaken) {
			add(name);
		}
	}
}

template <class Value>
void ColumnList::addUserAttributes(Value missing) {
	addAttributesOf<Value>(
	    [this](OperandId o) -> const auto& { return access_.mesh(o).vert_attr; },
	    [&](const std::string& name) { addVertexAttribute(name, missing); });
	addAttributesOf<Value>(
	    [this](OperandId o) -> const auto& { return access_.mesh(o).face_attr; },
	    [&](const std::string& name) { addFaceAttribute(name, missing); });
}

}  // namespace

OperandElementsAccess::OperandElementsAccess(const PerOperand<MeshModel*>& layers,
                                             const OperandArrays& read)
    : layers_(layers.size()), elements_(read.elements), vertices_(verticesOf(elements_)),
      numberings_(layers.size()) {
	std::copy(layers.begin(), layers.end(), layers_.begin());
	for (const OperandId operand : layers.operands()) {
		numberings_[operand] = numberingOf(operand);
	}
}

VertexNumbering<CMeshO> OperandElementsAccess::numberingOf(OperandId operand) const {
	return {mesh(operand), elements_[operand].vertices, vertices_.begin(operand)};
}

std::vector<AttributeColumn> attributeColumns(const OperandElementsAccess& access,
                                              const TextureList& textures,
                                              const std::vector<const char*>& reserved) {
	ColumnList list(access, textures, reserved);
	list.addVertexComponents();
	list.addFaceComponents();
	list.addTextureCoordinates();
	list.addSelection();
	list.addUserAttributes(Scalarm(0));
	list.addUserAttributes(Point3m(0, 0, 0));
	return std::move(list.columns);
}

AttributeColumn normalColumn(const OperandElementsAccess& access, PerOperand<bool> opposed) {
	// A normal is turned by the cofactors: so it stays normal under any matrix, and on the side of
	// its faces' fronts under one that mirrors.
	PerOperand<std::array<Point3m, 3>> cofactors(access.operands().count());
	PerOperand<bool> isMoved(access.operands().count()), has(access.operands().count());
	std::fill(has.begin(), has.end(), true);
	for (const OperandId operand : cofactors.operands()) {
		const Matrix44m& matrix = access.mesh(operand).Tr;
		const std::array<Point3m, 3> rows = rowsOf(matrix);
		cofactors[operand] = {rows[1] ^ rows[2], rows[2] ^ rows[0], rows[0] ^ rows[1]};
		isMoved[operand] = matrix != Matrix44m::Identity();
	}
	const auto get = [&access, cofactors, isMoved](OperandId operand, std::size_t v) {
		const Point3m& normal = access.mesh(operand).vert[v].cN();
		return isMoved[operand] ? turnedDirection(cofactors[operand], normal) : normal;
	};
	const auto prepare = [&access, opposed](MeshModel& layer, const AttributeSources& sources) {
		return [&access, &layer, &sources, opposed](std::size_t v, Point3m normal) {
			const bool isMix = sources.isMix(v);
			const OperandId operand = isMix ? OperandId{sources.mixOfVertex(v).face.operand}
			                                : access.vertex(sources.vertex[v]).operand;
			if (isMix) {
				normal.Normalize();
			}
			layer.cm.vert[v].N() = (sources.turned[v] != 0) != opposed[operand] ? -normal : normal;
		};
	};
	return vertexColumn<Point3m>(access, "vertex normals", has, Point3m(0, 0, 0), get, prepare);
}

}  // namespace index_boolean
