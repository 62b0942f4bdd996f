/** The report of surveys: figure of permeability against porosity, block sizes, maps, page. */
package org.hdispatch.app.survey.page;
