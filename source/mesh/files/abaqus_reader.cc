// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/shown_text.h>
#include <vfife/mesh/hexahedron_corners.h>

#include "abaqus_part.h"

#include <algorithm>
#include <memory>
#include <set>

// Input files of Abaqus ("Input Syntax Rules", "Defining an Assembly") and CalculiX.
namespace vfife
{
  namespace
  {
    using Part = AbaqusPart;

    class AbaqusReader
    {
    public:
      explicit AbaqusReader(const std::string &path)
        : path_(path)
        , text_(path)
        , whole_(text_)
        , place_(&whole_)
      {
        mesh_.names_without_case = true;
      }

      FileMesh read()
      {
        for (AbaqusKeyword keyword; text_.next_keyword(keyword);)
          read_keyword(keyword);
        if (part_ != nullptr || instance_ != nullptr)
          text_.refuse("a *PART or *INSTANCE has no end");
        add_elements();
        if (mesh_.elements.empty())
          text_.refuse("expected hexahedra (C3D8 elements), got none");
        for (const auto &[keyword, set] : sections_)
          check_section(keyword, set);
        name_sets();
        note_left_out();
        mesh_.finish(path_, node_sets_, surfaces_, regions_);
        return std::move(mesh_);
      }

    private:
      void read_keyword(const AbaqusKeyword &keyword)
      {
        const std::string &name = keyword.name;
        const bool in_step = in_step_ && name != "NSET" && name != "ELSET" && name != "SURFACE";
        if (name == "PART")
          {
            text_.check_options(keyword, {"NAME"});
            parts_.emplace_back(std::make_unique<Part>(text_));
            part_                                            = parts_.back().get();
            place_                                           = part_;
            part_of_name_[abaqus_key(keyword.value("NAME"))] = part_;
          }
        else if (name == "ENDPART")
          {
            part_  = nullptr;
            place_ = &whole_;
          }
        else if (name == "ASSEMBLY" || name == "ENDASSEMBLY")
          return;
        else if (name == "INSTANCE")
          begin_instance(keyword);
        else if (name == "ENDINSTANCE")
          end_instance();
        else if (name == "STEP" || name == "ENDSTEP")
          in_step_ = name == "STEP";
        else if (!in_step && place_->read(keyword))
          in_material_ = false;
        else
          read_other(keyword);
      }

      /** What is no mesh: said to be left out where it cannot change one, else refused. */
      void read_other(const AbaqusKeyword &keyword)
      {
        const std::string refusal = find_abaqus_refusal(keyword.name, in_material_ || in_step_);
        if (!refusal.empty())
          text_.refuse(keyword.shown + " " + refusal, keyword.line);
        if (keyword.name == "MATERIAL")
          in_material_ = true;
        else if (is_abaqus_model_keyword(keyword.name))
          in_material_ = false;
        if (keyword.name == "SOLIDSECTION" || keyword.name == "SHELLSECTION")
          {
            sections_.emplace_back(keyword, find_set(keyword));
            if (keyword.has("COMPOSITE"))
              text_.refuse(keyword.shown + " of layers (COMPOSITE) is not read", keyword.line);
          }
        if (!is_abaqus_output(keyword.name) &&
            std::find(left_out_.begin(), left_out_.end(), keyword.shown) == left_out_.end())
          left_out_.push_back(keyword.shown);
      }

      /** The set of a section as it is known where that stands. */
      const Part::Set *find_set(const AbaqusKeyword &keyword) const
      {
        const auto found = place_->element_sets.find(abaqus_key(keyword.value("ELSET")));
        if (found == place_->element_sets.end())
          text_.refuse(keyword.shown + ": element set \"" + shown(keyword.value("ELSET")) +
                         "\" does not exist",
                       keyword.line);
        section_parts_[&found->second] = place_;
        return &found->second;
      }

      /** A section makes elements a structure: shells and trusses are none that is read. */
      void check_section(const AbaqusKeyword &keyword, const Part::Set *set) const
      {
        for (const unsigned int element : set->members)
          if (section_parts_.at(set)->elements[element].kind != Part::ElementKind::hexahedron)
            text_.refuse(keyword.shown + " gives stiffness to elements other than hexahedra in \"" +
                           shown(set->name) + "\"; such elements are not available",
                         keyword.line);
      }

      void begin_instance(const AbaqusKeyword &keyword)
      {
        text_.check_options(keyword, {"NAME", "PART"});
        const auto found = part_of_name_.find(abaqus_key(keyword.value("PART")));
        if (found == part_of_name_.end())
          text_.refuse("part \"" + shown(keyword.value("PART")) + "\" does not exist");
        // What the instance adds is added to a copy of the part.
        parts_.push_back(std::make_unique<Part>(*found->second));
        instance_      = parts_.back().get();
        n_part_nodes_  = instance_->nodes.size();
        instance_name_ = keyword.value("NAME");
        placement_     = read_placement();
        place_         = instance_;
      }

      /** First a translation, then a turn about the line from a to b by an angle in degrees. */
      RigidMotion read_placement()
      {
        RigidMotion placement;
        for (unsigned int i = 0; i < 3; ++i)
          {
            std::vector<std::string> words;
            if (!text_.next_row(words))
              break;
            if (i == 2 || words.size() > (i == 0 ? 3 : 7))
              text_.refuse(
                "expected a translation and, in a second line, two points of an axis and an angle");
            words.resize(7);
            double numbers[7];
            for (unsigned int c = 0; c < 7; ++c)
              numbers[c] = text_.number(words[c]);
            const Vector3 a(numbers[0], numbers[1], numbers[2]);
            if (i == 0)
              {
                placement.translation = a;
                continue;
              }
            const Vector3 axis = Vector3(numbers[3], numbers[4], numbers[5]) - a;
            if (!(axis.norm() > 0))
              text_.refuse("the two points of the axis coincide");
            placement.rotation    = rotation_about(axis.normalized(), numbers[6] * degree);
            placement.translation = a + placement.rotation * (placement.translation - a);
          }
        return placement;
      }

      void end_instance()
      {
        if (instance_ == nullptr)
          text_.refuse("*END INSTANCE without *INSTANCE");
        const bool is_placed =
          !placement_.translation.isZero(0.) || !placement_.rotation.isIdentity(0.);
        if (is_placed && instance_->nodes.size() != n_part_nodes_)
          text_.refuse("nodes within a placed *INSTANCE are not read. Define them in the part");
        whole_.add_instance(instance_name_, *instance_, placement_);
        instance_ = nullptr;
        place_    = &whole_;
      }

      void add_elements()
      {
        for (const Vector3 &x : whole_.nodes)
          mesh_.nodes.push_back(x);
        for (const Part::Element &element : whole_.elements)
          {
            hexahedra_.push_back(mesh_.elements.size());
            if (element.kind != Part::ElementKind::hexahedron)
              continue;
            CellNodes corners;
            for (unsigned int k = 0; k < 8; ++k)
              corners[corner_of_files[k]] = element.nodes[k];
            mesh_.elements.push_back(corners);
            mesh_.element_lines.push_back(element.line);
          }
      }

      /** Sets of the assembly, or of a file without, by their names; those of an instance by theirs
       * where no other has it, else as INSTANCE.NAME. An instance is a region. */
      void name_sets()
      {
        std::multiset<std::string> names;
        const auto                 count = [&names](const AbaqusMesh &part) {
          std::set<std::string> own;
          for (const auto *sets : {&part.node_sets, &part.element_sets})
            for (const auto &set : *sets)
              own.insert(set.first);
          for (const auto &surface : part.surfaces)
            own.insert(surface.first);
          names.insert(own.begin(), own.end());
        };
        count(whole_);
        for (const auto &instance : whole_.instances)
          count(*instance.second.part);
        for (const auto &[key, instance] : whole_.instances)
          {
            const std::string prefix = instance.name + ".";
            add_sets(*instance.part,
                     instance.first_node,
                     instance.first_element,
                     [&](const auto &set) {
                       return names.count(abaqus_key(set.name)) == 1 ? set.name : prefix + set.name;
                     });
            for (unsigned int e = 0; e < instance.part->elements.size(); ++e)
              add_to_region(instance.name, instance.first_element + e);
          }
        add_sets(whole_, 0, 0, [](const auto &set) { return set.name; });
      }

      template <typename NameOf>
      void add_sets(const AbaqusMesh  &part,
                    const unsigned int first_node,
                    const unsigned int first_element,
                    const NameOf      &name_of)
      {
        for (const auto &[key, set] : part.node_sets)
          if (!set.is_internal)
            for (const unsigned int member : set.members)
              node_sets_[name_of(set)].push_back(first_node + member);
        for (const auto &[key, set] : part.element_sets)
          if (!set.is_internal)
            for (const unsigned int member : set.members)
              add_to_region(name_of(set), first_element + member);
        for (const auto &[key, surface] : part.surfaces)
          add_surface(part, surface, first_node, name_of(surface));
      }

      /** A hexahedron is one of a region, a 4-node element a face of a surface. */
      void add_to_region(const std::string &name, const unsigned int element)
      {
        const Part::Element &of = whole_.elements[element];
        if (of.kind == Part::ElementKind::hexahedron)
          regions_[name].push_back(hexahedra_[element]);
        else if (of.kind == Part::ElementKind::face)
          surfaces_[name].push_back(
            {{{of.nodes[0], of.nodes[1], of.nodes[2], of.nodes[3]}}, of.line});
      }

      void add_surface(const AbaqusMesh    &part,
                       const Part::Surface &surface,
                       const unsigned int   first_node,
                       const std::string   &name)
      {
        auto &faces = surfaces_[name];
        for (FileMesh::Face face : surface.faces)
          {
            for (unsigned int &node : face.nodes)
              node += first_node;
            faces.push_back(face);
          }
        if (surface.free_elements.empty())
          return;
        if (free_faces_.empty())
          free_faces_ = mesh_.find_boundary();
        for (const auto &[element, line] : surface.free_elements)
          for (const auto &corners : outward_faces)
            {
              FileMesh::Face face{{}, line};
              for (unsigned int i = 0; i < 4; ++i)
                face.nodes[i] =
                  first_node + part.elements[element].nodes[place_of_corner(corners[i])];
              auto nodes = face.nodes;
              std::sort(nodes.begin(), nodes.end());
              if (free_faces_.count(nodes) != 0)
                faces.push_back(face);
            }
      }

      /** In the file's order. */
      static unsigned int place_of_corner(const unsigned int corner)
      {
        return std::find(corner_of_files, corner_of_files + 8, corner) - corner_of_files;
      }

      void note_left_out()
      {
        mesh_.warnings.insert(mesh_.warnings.end(), whole_.warnings.begin(), whole_.warnings.end());
        for (const auto &part : part_of_name_)
          for (const std::string &warning : part.second->warnings)
            if (std::find(mesh_.warnings.begin(), mesh_.warnings.end(), warning) ==
                mesh_.warnings.end())
              mesh_.warnings.push_back(warning);
        if (!left_out_.empty())
          mesh_.notes.push_back("left out: " + list_of(left_out_) +
                                " (materials, supports and loads are those of the parameter file)");
      }

      const std::string                                       &path_;
      AbaqusText                                               text_;
      Part                                                     whole_; ///< file or assembly
      Part                                                    *place_; ///< what is read now
      std::vector<std::unique_ptr<Part>>                       parts_;
      std::map<std::string, Part *>                            part_of_name_;
      Part                                                    *part_     = nullptr;
      Part                                                    *instance_ = nullptr;
      std::string                                              instance_name_;
      RigidMotion                                              placement_;
      std::size_t                                              n_part_nodes_ = 0;
      bool                                                     in_material_  = false;
      bool                                                     in_step_      = false;
      std::vector<std::pair<AbaqusKeyword, const Part::Set *>> sections_;
      mutable std::map<const Part::Set *, const Part *>        section_parts_;
      std::vector<std::string>                                 left_out_;
      std::vector<unsigned int>                                hexahedra_; ///< of elements
      FileMesh                                                 mesh_;
      FileMesh::Members                                        node_sets_, regions_;
      FileMesh::Surfaces                                       surfaces_;
      FaceSet                                                  free_faces_;
    };
  } // namespace

  FileMesh read_abaqus(const std::string &path)
  {
    return AbaqusReader(path).read();
  }
} // namespace vfife
