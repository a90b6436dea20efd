//! Countries of signals: two letters, three letters, or names, depending on the version.

use super::{Lexical, Quirk, trimmed};

/// Codes of ISO 3166-1 in two and in three letters, sorted.
const CODES: &str = "\
    ADAND AEARE AFAFG AGATG AIAIA ALALB AMARM AOAGO AQATA ARARG ASASM ATAUT \
    AUAUS AWABW AXALA AZAZE BABIH BBBRB BDBGD BEBEL BFBFA BGBGR BHBHR BIBDI \
    BJBEN BLBLM BMBMU BNBRN BOBOL BQBES BRBRA BSBHS BTBTN BVBVT BWBWA BYBLR \
    BZBLZ CACAN CCCCK CDCOD CFCAF CGCOG CHCHE CICIV CKCOK CLCHL CMCMR CNCHN \
    COCOL CRCRI CUCUB CVCPV CWCUW CXCXR CYCYP CZCZE DEDEU DJDJI DKDNK DMDMA \
    DODOM DZDZA ECECU EEEST EGEGY EHESH ERERI ESESP ETETH FIFIN FJFJI FKFLK \
    FMFSM FOFRO FRFRA GAGAB GBGBR GDGRD GEGEO GFGUF GGGGY GHGHA GIGIB GLGRL \
    GMGMB GNGIN GPGLP GQGNQ GRGRC GSSGS GTGTM GUGUM GWGNB GYGUY HKHKG HMHMD \
    HNHND HRHRV HTHTI HUHUN IDIDN IEIRL ILISR IMIMN ININD IOIOT IQIRQ IRIRN \
    ISISL ITITA JEJEY JMJAM JOJOR JPJPN KEKEN KGKGZ KHKHM KIKIR KMCOM KNKNA \
    KPPRK KRKOR KWKWT KYCYM KZKAZ LALAO LBLBN LCLCA LILIE LKLKA LRLBR LSLSO \
    LTLTU LULUX LVLVA LYLBY MAMAR MCMCO MDMDA MEMNE MFMAF MGMDG MHMHL MKMKD \
    MLMLI MMMMR MNMNG MOMAC MPMNP MQMTQ MRMRT MSMSR MTMLT MUMUS MVMDV MWMWI \
    MXMEX MYMYS MZMOZ NANAM NCNCL NENER NFNFK NGNGA NINIC NLNLD NONOR NPNPL \
    NRNRU NUNIU NZNZL OMOMN PAPAN PEPER PFPYF PGPNG PHPHL PKPAK PLPOL PMSPM \
    PNPCN PRPRI PSPSE PTPRT PWPLW PYPRY QAQAT REREU ROROU RSSRB RURUS RWRWA \
    SASAU SBSLB SCSYC SDSDN SESWE SGSGP SHSHN SISVN SJSJM SKSVK SLSLE SMSMR \
    SNSEN SOSOM SRSUR SSSSD STSTP SVSLV SXSXM SYSYR SZSWZ TCTCA TDTCD TFATF \
    TGTGO THTHA TJTJK TKTKL TLTLS TMTKM TNTUN TOTON TRTUR TTTTO TVTUV TWTWN \
    TZTZA UAUKR UGUGA UMUMI USUSA UYURY UZUZB VAVAT VCVCT VEVEN VGVGB VIVIR \
    VNVNM VUVUT WFWLF WSWSM YEYEM YTMYT ZAZAF ZMZMB ZWZWE";

/// Bytes of an entry of [`CODES`], and from one entry to the next.
const ENTRY: usize = 5;
const STEP: usize = ENTRY + 1;

/// Names that OpenDRIVE 1.5 lists (`e_countryCode`) and that are no code, with their codes.
const NAMES: [(&str, [u8; 2]); 7] = [
    ("Austria", *b"AT"),
    ("Brazil", *b"BR"),
    ("China", *b"CN"),
    ("France", *b"FR"),
    ("Germany", *b"DE"),
    ("Italy", *b"IT"),
    ("Switzerland", *b"CH"),
];

/// The catalogue that the standard itself brings.
const GENERIC: &str = "OpenDRIVE";

/// How a country was written. Which form is due depends on the version: names in 1.5, codes of three letters in 1.4 to 1.6,
/// of two from 1.7 on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CountryForm {
    /// `DE`
    Alpha2,
    /// `DEU`
    Alpha3,
    /// `Germany`
    Name,
}

/// A country, or the standard's own catalogue of signals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Country {
    /// A country by its code of ISO 3166-1 alpha-2, with the form that it was written in.
    Code([u8; 2], CountryForm),
    /// `OpenDRIVE`
    Generic,
}

/// Reads a country: a code in two or three letters or one of the standard's names, in any case, or `OpenDRIVE`.
pub fn country(raw: &[u8]) -> Lexical<Country> {
    let (text, space) = trimmed(raw);
    if text.is_empty() {
        return Lexical::none(Quirk::Empty);
    }
    let by_code = |from: usize, to: usize, form| {
        let codes =
            CODES.as_bytes().chunks(STEP).filter_map(|entry| Some((entry, entry.get(from..to)?)));
        let (entry, code) = { codes }.find(|(_, code)| text.eq_ignore_ascii_case(code))?;
        Some((Country::Code([entry[0], entry[1]], form), text == code))
    };
    let found = match text.len() {
        2 => by_code(0, 2, CountryForm::Alpha2),
        3 => by_code(2, ENTRY, CountryForm::Alpha3),
        _ if text.eq_ignore_ascii_case(GENERIC.as_bytes()) => {
            Some((Country::Generic, text == GENERIC.as_bytes()))
        }
        _ => NAMES
            .iter()
            .find(|(name, _)| text.eq_ignore_ascii_case(name.as_bytes()))
            .map(|(name, code)| (Country::Code(*code, CountryForm::Name), text == name.as_bytes())),
    };
    match found {
        Some((country, true)) => Lexical { value: Some(country), quirk: space },
        Some((country, false)) => Lexical::some(country, Quirk::OtherCase),
        None => Lexical::none(Quirk::UnknownCountry),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_have_one_width() {
        assert_eq!(CODES.len() % STEP, ENTRY);
        for entry in CODES.as_bytes().chunks(STEP) {
            assert!(entry[..ENTRY].iter().all(u8::is_ascii_uppercase));
        }
    }
}
