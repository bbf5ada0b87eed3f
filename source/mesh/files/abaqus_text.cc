// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "abaqus_text.h"

#include <vfife/base/errors.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/shown_text.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>

namespace vfife
{
  namespace
  {
    /** The words between commas, without blanks around them; within quotation marks a comma is
     * text. */
    std::vector<std::string> split_cells(const std::string &line)
    {
      std::vector<std::string> words(1);
      bool                     quoted = false;
      for (const char letter : line)
        {
          quoted = quoted != (letter == '"');
          if (letter == ',' && !quoted)
            words.emplace_back();
          else
            words.back() += letter;
        }
      for (std::string &word : words)
        word = trimmed(word);
      while (!words.empty() && words.back().empty())
        words.pop_back();
      return words;
    }

    std::string without_blanks(const std::string &text)
    {
      std::string result;
      for (const char letter : text)
        if (letter != ' ' && letter != '\t')
          result += letter;
      return result;
    }

    std::string without_quotes(const std::string &text)
    {
      return text.size() >= 2 && text.front() == '"' && text.back() == '"'
               ? text.substr(1, text.size() - 2)
               : text;
    }

    const std::vector<std::string> output = {"",
                                             "HEADING",
                                             "PREPRINT",
                                             "RESTART",
                                             "NODEPRINT",
                                             "NODEFILE",
                                             "ELPRINT",
                                             "ELFILE",
                                             "OUTPUT",
                                             "NODEOUTPUT",
                                             "ELEMENTOUTPUT",
                                             "CONTACTFILE",
                                             "CONTACTOUTPUT",
                                             "CONTACTPRINT",
                                             "SECTIONPRINT",
                                             "SECTIONFILE",
                                             "MONITOR",
                                             "FILEFORMAT",
                                             "ENERGYOUTPUT",
                                             "ENERGYPRINT",
                                             "ENERGYFILE",
                                             "HISTORYOUTPUT",
                                             "PRINT",
                                             "TIMEPOINTS"};

    /** Of a model, without effect on its mesh. */
    const std::vector<std::string> left_out = {"MATERIAL",
                                               "SOLIDSECTION",
                                               "SHELLSECTION",
                                               "AMPLITUDE",
                                               "BOUNDARY",
                                               "INITIALCONDITIONS",
                                               "ORIENTATION",
                                               "TRANSFORM",
                                               "SURFACEINTERACTION",
                                               "SURFACEBEHAVIOR",
                                               "FRICTION",
                                               "COHESIVEBEHAVIOR",
                                               "GAPCONDUCTANCE",
                                               "GAPHEATGENERATION",
                                               "GAPRADIATION",
                                               "CONTACTPAIR",
                                               "CONTACT",
                                               "CONTACTINCLUSIONS",
                                               "CONTACTEXCLUSIONS",
                                               "CONTACTPROPERTYASSIGNMENT",
                                               "CONTACTINITIALIZATIONASSIGNMENT",
                                               "CONTACTINITIALIZATIONDATA",
                                               "CONTACTFORMULATION",
                                               "CONTACTCONTROLS",
                                               "CONTACTCONTROLSASSIGNMENT",
                                               "CONTACTDAMPING",
                                               "CONTACTSTABILIZATION",
                                               "SURFACEPROPERTYASSIGNMENT",
                                               "SECTIONCONTROLS",
                                               "HOURGLASSSTIFFNESS",
                                               "DISTRIBUTION",
                                               "DISTRIBUTIONTABLE",
                                               "PHYSICALCONSTANTS",
                                               "FILTER",
                                               "DAMPING",
                                               "DAMPINGCONTROLS",
                                               "NODALTHICKNESS",
                                               "NORMAL",
                                               "DESIGNVARIABLES",
                                               "INTEGRATEDOUTPUTSECTION",
                                               "NOANALYSIS",
                                               "VALUESATINFINITY"};

    const std::vector<std::string> mesh = {"NODE",
                                           "SYSTEM",
                                           "ELEMENT",
                                           "NSET",
                                           "ELSET",
                                           "SURFACE",
                                           "NGEN",
                                           "ELGEN",
                                           "ELCOPY",
                                           "PART",
                                           "ENDPART",
                                           "ASSEMBLY",
                                           "ENDASSEMBLY",
                                           "INSTANCE",
                                           "ENDINSTANCE",
                                           "STEP",
                                           "ENDSTEP"};

    constexpr const char *places = "changes the places of nodes and is not read. Write nodes and "
                                   "elements at their final places",
                         *joins  = "joins nodes or parts and is not read",
                         *adds   = "adds mass, stiffness or elements and is not read";

    const std::map<std::string, const char *> &refused()
    {
      static const std::map<std::string, const char *> keywords = {
        {"INCLUDE", "is not followed: put the mesh into one file"},
        {"PARAMETER", "is not read: write numbers"},
        {"NMAP", places},
        {"NCOPY", places},
        {"NFILL", places},
        {"IMPERFECTION", places},
        {"SYMMETRICMODELGENERATION", places},
        {"MPC", joins},
        {"EQUATION", joins},
        {"TIE", joins},
        {"RIGIDBODY", joins},
        {"COUPLING", joins},
        {"KINEMATIC", joins},
        {"DISTRIBUTING", joins},
        {"KINEMATICCOUPLING", joins},
        {"DISTRIBUTINGCOUPLING", joins},
        {"SHELLTOSOLIDCOUPLING", joins},
        {"EMBEDDEDELEMENT", joins},
        {"FASTENER", joins},
        {"CYCLICSYMMETRYMODEL", joins},
        {"PRE-TENSIONSECTION", joins},
        {"CLEARANCE", places},
        {"MASS", adds},
        {"ROTARYINERTIA", adds},
        {"NONSTRUCTURALMASS", adds},
        {"SPRING", adds},
        {"DASHPOT", adds},
        {"GAP", adds},
        {"SHELLGENERALSECTION", adds},
        {"MEMBRANESECTION", adds},
        {"BEAMSECTION", adds},
        {"BEAMGENERALSECTION", adds},
        {"SURFACESECTION", adds},
        {"COHESIVESECTION", adds},
        {"CONNECTORSECTION", adds},
        {"GASKETSECTION", adds},
        {"REBAR", adds},
        {"REBARLAYER", adds},
        {"USERELEMENT", adds},
        {"UELPROPERTY", adds},
        {"MATRIXINPUT", adds},
        {"MATRIXASSEMBLE", adds},
        {"SUBSTRUCTUREPROPERTY", adds},
        {"IMPORT", adds},
        {"DISPLAYBODY", adds}};
      return keywords;
    }

    bool is_in(const std::vector<std::string> &list, const std::string &keyword)
    {
      return std::find(list.begin(), list.end(), keyword) != list.end();
    }

    /** The keyword of a mesh that a slip has made another one of; empty where none is alike. */
    std::string find_meant(const std::string &keyword)
    {
      for (const std::string &known : mesh)
        if (edit_distance(keyword, known) <= (known.size() > 5 ? 2 : 1))
          return known;
      return "";
    }
  } // namespace

  bool AbaqusKeyword::has(const std::string &option) const
  {
    return options.count(option) != 0;
  }

  std::string AbaqusKeyword::value(const std::string &option) const
  {
    const auto found = options.find(option);
    return found == options.end() ? "" : found->second;
  }

  std::string abaqus_key(const std::string &name)
  {
    return boost::to_upper_copy(name, std::locale::classic());
  }

  AbaqusText::AbaqusText(const std::string &path)
    : path_(path)
    , file_(path)
    , lines_(file_)
  {
  }

  bool AbaqusText::next_line()
  {
    do
      {
        if (!lines_.next(text_))
          return false;
        text_ = trimmed(text_);
      }
    while (text_.empty() || text_.rfind("**", 0) == 0);
    return true;
  }

  bool AbaqusText::next_keyword(AbaqusKeyword &keyword)
  {
    while (!is_waiting_)
      {
        if (!next_line())
          {
            line_ = lines_.number();
            return false;
          }
        is_waiting_ = text_[0] == '*';
      }
    is_waiting_       = false;
    line_             = lines_.number();
    std::string whole = text_;
    while (whole.back() == ',' && next_line())
      {
        if (text_[0] == '*')
          {
            is_waiting_ = true;
            break;
          }
        whole += " " + text_;
      }
    keyword                              = {};
    keyword.line                         = line_;
    const std::vector<std::string> words = split_cells(whole);
    keyword.shown                        = words.empty() ? "*" : abaqus_key(words[0]);
    keyword.name                         = without_blanks(keyword.shown).substr(1);
    for (std::size_t i = 1; i < words.size(); ++i)
      {
        const auto equals = words[i].find('=');
        keyword.options[without_blanks(abaqus_key(words[i].substr(0, equals)))] =
          equals == std::string::npos ? "" : without_quotes(trimmed(words[i].substr(equals + 1)));
      }
    return true;
  }

  bool AbaqusText::next_row(std::vector<std::string> &cells)
  {
    if (is_waiting_)
      return false;
    if (!next_line())
      return false;
    if (text_[0] == '*')
      {
        is_waiting_ = true;
        return false;
      }
    line_    = lines_.number();
    goes_on_ = text_.back() == ',';
    cells    = split_cells(text_);
    for (std::string &cell : cells)
      cell = without_quotes(cell);
    return true;
  }

  bool AbaqusText::goes_on() const
  {
    return goes_on_;
  }

  void AbaqusText::refuse(const std::string &message) const
  {
    refuse(message, line_);
  }

  void AbaqusText::refuse(const std::string &message, const unsigned int line) const
  {
    throw InputError(path_ + ":" + std::to_string(line) + ": " + message);
  }

  void AbaqusText::check_options(const AbaqusKeyword            &keyword,
                                 const std::vector<std::string> &known) const
  {
    for (const auto &option : keyword.options)
      if (!option.first.empty() &&
          std::find(known.begin(), known.end(), option.first) == known.end())
        refuse("the option " + shown(option.first) + " of " + keyword.shown + " is not read" +
                 did_you_mean(option.first, known),
               keyword.line);
  }

  unsigned int AbaqusText::line() const
  {
    return line_;
  }

  unsigned long AbaqusText::label(const std::string &word) const
  {
    if (word.empty() || word.find_first_not_of("0123456789") != std::string::npos ||
        word.size() > 18)
      refuse("expected the number of a node or element, got \"" + shown(word) + "\"");
    return std::stoul(word);
  }

  double AbaqusText::number(const std::string &word) const
  {
    if (word.empty())
      return 0.;
    const auto value = plain_number(word);
    if (!value)
      refuse("expected a number, got \"" + shown(word) + "\"");
    return *value;
  }

  std::string find_abaqus_refusal(const std::string &keyword, const bool inside)
  {
    const auto found = refused().find(keyword);
    if (found != refused().end())
      return found->second;
    if (is_in(output, keyword) || is_in(left_out, keyword) || (inside && is_in(mesh, keyword)))
      return "";
    const std::string meant = find_meant(keyword);
    if (!meant.empty())
      return "is an unknown keyword; did you mean *" + meant + "?";
    return inside ? "" : "is an unknown keyword" + did_you_mean(keyword, left_out);
  }

  bool is_abaqus_model_keyword(const std::string &keyword)
  {
    return keyword != "DAMPING" && is_in(left_out, keyword);
  }

  bool is_abaqus_output(const std::string &keyword)
  {
    return is_in(output, keyword);
  }
} // namespace vfife
