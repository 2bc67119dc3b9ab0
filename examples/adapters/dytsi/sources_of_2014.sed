# Lets today's compilers and libraries take DYTSI's sources.
s/xercesc_3_1/xercesc/g
s/\bisnan(/std::isnan(/g
